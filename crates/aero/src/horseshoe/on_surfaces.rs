//! Horseshoes whose legs run along their surface to its trailing edge before they leave along the stream, strip by strip: the lines between
//! two strips are computed once for both.

use super::{Horseshoe, Receivers, leg, seen_from, segment, stretched};
use crate::lattice::Lattice;
use faer::MatMut;
use faer::reborrow::ReborrowMut as _;
use nalgebra::Vector3;
use pulp::{Arch, Simd, WithSimd};
use rayon::prelude::*;

/// Strips that a thread works on at a time, always the same ones.
const STRIPS: usize = 8;

/// The horseshoes of boxes that stand at an angle to the stream or to each other: they run along the corners of the same boxes `closed`
/// (joined where they meet), their legs along the sides of the strip to its trailing edge, and leave it along the stream. All of a
/// surface have the core of its smallest box.
pub(crate) fn horseshoes_on_surfaces(lattice: &Lattice, closed: &Lattice, beta: f64) -> Vec<Horseshoe> {
    let boxes = lattice.boxes.iter().zip(&closed.boxes);
    let mut all: Vec<Horseshoe> = boxes.map(|(panel, at)| Horseshoe::new(panel, at, beta)).collect();
    for surface in &lattice.surfaces {
        let own = surface.first_box..surface.first_box + surface.spanwise * surface.chordwise;
        let core = all[own.clone()].iter().map(|vortex| vortex.core).fold(f64::INFINITY, f64::min);
        for (vortices, boxes) in
            all[own.clone()].chunks_mut(surface.chordwise).zip(closed.boxes[own].chunks(surface.chordwise))
        {
            let [_, edge_1, edge_2, _] = boxes[surface.chordwise - 1].corners;
            for vortex in vortices {
                let (edge_1, edge_2) = (stretched(&edge_1, beta), stretched(&edge_2, beta));
                let lengths_2 = [(vortex.from - edge_1).norm_squared(), (edge_2 - vortex.to).norm_squared()];
                vortex.edges = Some([(edge_1, lengths_2[0]), (edge_2, lengths_2[1])]);
                vortex.core = core;
            }
        }
    }
    all
}

impl Receivers {
    /// Adds `factor` times the incidences that each receiver's flow lacks for a unit `cp` of each box of a surface, a column a box:
    /// -v.n/V.
    pub(crate) fn add_incidences_of_surface(
        &self,
        vortices: &[Horseshoe],
        chordwise: usize,
        factor: f64,
        columns: MatMut<'_, f64>,
    ) {
        let together = STRIPS * chordwise;
        columns.par_col_chunks_mut(together).zip(vortices.par_chunks(together)).for_each(
            |(columns, vortices)| {
                Arch::new().dispatch(Strips { to: self, vortices, chordwise, factor, columns });
            },
        );
    }
}

/// Strips side by side, boxes from leading to trailing edge.
struct Strips<'a> {
    to: &'a Receivers,
    vortices: &'a [Horseshoe],
    chordwise: usize,
    factor: f64,
    columns: MatMut<'a, f64>,
}

/// From an end of a bound vortex along the side of its strip to the trailing edge.
#[derive(PartialEq)]
struct Line {
    end: Vector3<f64>,
    edge: Vector3<f64>,
    length_2: f64,
}

/// The lines along one side of a strip, seen from all receivers.
#[derive(Default)]
struct Side {
    lines: Vec<Line>,
    /// 4 pi times the velocity along the normal of a circulation of 1 that goes out along each line and leaves along the stream, line by line.
    out: Vec<Vec<f64>>,
    /// Distance from each line's end, line by line.
    distances: Vec<Vec<f64>>,
}

fn lines(strip: &[Horseshoe], side: usize) -> Vec<Line> {
    let line = |vortex: &Horseshoe| {
        let (edge, length_2) = vortex.edges?[side];
        Some(Line { end: [vortex.from, vortex.to][side], edge, length_2 })
    };
    strip.iter().filter_map(line).collect()
}

impl WithSimd for Strips<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) {
        let Self { to, vortices, chordwise, factor, mut columns } = self;
        let [mut left, mut right] = [Side::default(), Side::default()];
        for (strip, vortices) in vortices.chunks(chordwise).enumerate() {
            std::mem::swap(&mut left, &mut right);
            let [side_1, side_2] = [0, 1].map(|side| lines(vortices, side));
            if left.lines != side_1 {
                left.look_at(side_1, vortices[0].core, to);
            }
            right.look_at(side_2, vortices[0].core, to);
            for (row, vortex) in vortices.iter().enumerate() {
                let column = columns.rb_mut().col_mut(strip * chordwise + row);
                // A column of a new matrix is contiguous.
                let Some(column) = column.try_as_col_major_mut() else { return };
                let out = column.as_slice_mut();
                let [left, right] = [&left, &right].map(|side| (&*side.distances[row], &*side.out[row]));
                add_box(to, vortex, vortex.scale(factor), [left, right], out);
            }
        }
    }
}

impl Side {
    /// All lines end at one edge.
    #[inline(always)]
    fn look_at(&mut self, lines: Vec<Line>, own_core: f64, to: &Receivers) {
        let count = to.core.len();
        let [px, py, pz] = to.point.each_ref().map(|values| &values[..count]);
        let [nx, ny, nz] = to.normal.each_ref().map(|values| &values[..count]);
        let cores = &to.core[..count];
        let edge = lines[0].edge;
        let (mut from_edge, mut by_leg) = (vec![0.0; count], vec![0.0; count]);
        let (far, legs) = (&mut from_edge[..count], &mut by_leg[..count]);
        for i in 0..count {
            let core = cores[i].min(own_core);
            let (r, l) = seen_from(&edge, [px[i], py[i], pz[i]], core);
            let turn = leg(r[0], r[1] * r[1] + r[2] * r[2], l, core * core);
            far[i] = l;
            legs[i] = turn * (r[1] * nz[i] - r[2] * ny[i]);
        }
        self.out.resize_with(lines.len(), || vec![0.0; count]);
        self.distances.resize_with(lines.len(), || vec![0.0; count]);
        for ((line, out), distances) in lines.iter().zip(&mut self.out).zip(&mut self.distances) {
            let (out, distances) = (&mut out[..count], &mut distances[..count]);
            for i in 0..count {
                let core = cores[i].min(own_core);
                let point = [px[i], py[i], pz[i]];
                let (r, l) = seen_from(&line.end, point, core);
                let to_edge = [point[0] - edge.x, point[1] - edge.y, point[2] - edge.z];
                let v = segment((r, l), (to_edge, far[i]), line.length_2, core * core);
                distances[i] = l;
                out[i] = legs[i] + (v[0] * nx[i] + v[1] * ny[i] + v[2] * nz[i]);
            }
        }
        self.lines = lines;
    }
}

/// Adds the bound vortex of a box, what goes out along the right side and what comes in along the left one.
#[inline(always)]
fn add_box(
    to: &Receivers,
    vortex: &Horseshoe,
    scale: f64,
    [left, right]: [(&[f64], &[f64]); 2],
    sum: &mut [f64],
) {
    let count = sum.len();
    let [px, py, pz] = to.point.each_ref().map(|values| &values[..count]);
    let [nx, ny, nz] = to.normal.each_ref().map(|values| &values[..count]);
    let (cores, own_core) = (&to.core[..count], vortex.core);
    let [(l1, come_in), (l2, go_out)] =
        [left, right].map(|(distances, out)| (&distances[..count], &out[..count]));
    let (from, end) = (vortex.from, vortex.to);
    for i in 0..count {
        let core = cores[i].min(own_core);
        let r1 = [px[i] - from.x, py[i] - from.y, pz[i] - from.z];
        let r2 = [px[i] - end.x, py[i] - end.y, pz[i] - end.z];
        let v = segment((r1, l1[i]), (r2, l2[i]), vortex.length_2, core * core);
        sum[i] += scale * ((v[0] * nx[i] + v[1] * ny[i] + v[2] * nz[i]) + (go_out[i] - come_in[i]));
    }
}

#[cfg(test)]
mod tests {
    use super::super::tests::{biot_savart, line, points, vortex};
    use super::*;
    use crate::mirror::MirrorPlane;
    use crate::seams::Seams;
    use faer::Mat;
    use nalgebra::Rotation3;
    use std::f64::consts::PI;

    /// 4 pi times the velocity of a horseshoe of circulation 1 whose legs leave the surface at `edges`.
    fn velocity(own: &Horseshoe, edges: [Vector3<f64>; 2], point: Vector3<f64>, core: f64) -> Vector3<f64> {
        let lengths_2 = [own.from - edges[0], edges[1] - own.to].map(|side| side.norm_squared());
        let own =
            Horseshoe { edges: Some([(edges[0], lengths_2[0]), (edges[1], lengths_2[1])]), core, ..*own };
        let axis = |axis: usize| [0, 1, 2].map(|at| if at == axis { 1.0 } else { 0.0 }).to_vec();
        let to = Receivers {
            point: [0, 1, 2].map(|axis| vec![point[axis]; 3]),
            normal: [0, 1, 2].map(axis),
            core: vec![core; 3],
        };
        let mut found = Mat::zeros(3, 1);
        to.add_incidences_of_surface(&[own], 1, -4.0 * PI / own.circulation, found.as_mut());
        Vector3::new(found[(0, 0)], found[(1, 0)], found[(2, 0)])
    }

    #[test]
    fn horseshoes_along_the_surface_obey_biot_and_savart() {
        let own = vortex([0.3, -0.4, 0.1], [0.5, 0.7, 0.3]);
        let edges = [Vector3::new(1.1, -0.5, -0.1), Vector3::new(1.4, 0.8, 0.2)];
        let straight = [own.from + Vector3::x(), own.to + Vector3::x()];
        let mut points = points(&own);
        // On the extensions of a side and, upstream, of a leg.
        points.extend([edges[0] + (edges[0] - own.from), own.from + (own.from - edges[0]) * 0.7]);
        points.push(edges[1] - Vector3::x() * 2.0);
        for point in points {
            for edges in [edges, straight] {
                let bent = velocity(&own, edges, point, 1e-6);
                let want = biot_savart(&line(&own, edges), &point);
                assert!((bent - want).norm() < 1e-6 * (1e-3 + want.norm()), "{point}: {bent} {want}");
            }
        }
    }

    /// In the middle of a long side 4 pi v = 2/rho outside of the core and 2 rho/core² in it, round the
    /// side's direction.
    #[test]
    fn sides_along_the_surface_have_the_same_core() {
        let (long, core) = (1e6, 0.01);
        let direction = Vector3::new(0.8, 0.0, 0.6);
        for side in [0, 1] {
            let mut ends = [[0.0, 0.0, 0.0], [0.0, 0.0, 0.0]].map(Vector3::from);
            ends[1 - side].y = if side == 0 { 1e12 } else { -1e12 };
            let own = vortex((ends[0] - direction * long).into(), (ends[1] - direction * long).into());
            let edges = [ends[0] + direction * long, ends[1] + direction * long];
            // It comes in along side 1 and goes out along side 2.
            let along = if side == 0 { -direction } else { direction };
            for rho in [1e-4, 0.002, 0.0099, 0.0101, 0.02, 1.0] {
                for away in [Vector3::y(), direction.cross(&Vector3::y())] {
                    let r = away * rho;
                    let got = velocity(&own, edges, r, core);
                    let want = along.cross(&r) * 2.0 / f64::max(rho * rho, core * core);
                    assert!((got - want).norm() < 1e-3 * want.norm(), "side {side} at {rho}: {got} {want}");
                }
            }
        }
    }

    /// Twenty strips, one of them moved away from its neighbours: what is computed strip by strip is what each box has alone.
    #[test]
    fn lines_between_strips_are_shared_only_where_they_are_the_same() {
        let mut lattice =
            Lattice::trapezoid(1, [0.0, 0.1, 0.0], 1.0, [0.4, 3.0, 0.3], 0.7, [3, 20]).expect("boxes");
        let seams = Seams::of(&lattice, MirrorPlane::None);
        let turn = Rotation3::from_scaled_axis(Vector3::new(0.1, 0.05, -0.02));
        for corner in lattice.boxes[21..].iter_mut().flat_map(|panel| &mut panel.corners) {
            *corner = turn * *corner;
        }
        let mut closed = seams.closed(&lattice);
        for corner in closed.boxes[30..33].iter_mut().flat_map(|panel| &mut panel.corners) {
            corner.z += 0.01;
        }
        let vortices = horseshoes_on_surfaces(&lattice, &closed, 0.8);
        let to = Receivers::new(&lattice, 0.8, Some(-0.05));
        let mut all = Mat::zeros(60, 60);
        to.add_incidences_of_surface(&vortices, 3, 0.7, all.as_mut());
        for at in 0..60 {
            let mut alone = Mat::zeros(60, 1);
            to.add_incidences_of_surface(&vortices[at..=at], 1, 0.7, alone.as_mut());
            assert_eq!(all.subcols(at, 1), alone.as_ref(), "box {at}");
        }
        let is_shared = |strip: usize| {
            lines(&vortices[3 * strip - 3..3 * strip], 1) == lines(&vortices[3 * strip..3 * strip + 3], 0)
        };
        assert_eq!([9, 10, 11, 12].map(is_shared), [true, false, false, true]);
    }
}
