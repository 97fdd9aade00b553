//! The influence of vortices that run along the strips of bent surfaces.
//!
//! Every leg of a strip's horseshoes runs along one of its sides to its trailing edge and leaves there, and neighbouring strips
//! share a side. So a side's points, their distances and what legs along it give are computed once for all of its vortices, and
//! a horseshoe is the difference of two of its sides and its bound segment: a quarter of the roots and divisions of
//! horseshoes one by one. The velocities are those of [`crate::horseshoe`]; the core of a side is that of the smallest
//! box beside it.

#![expect(clippy::inline_always, reason = "a call would leave the vector instructions of the loop around it")]

use crate::horseshoe::{Horseshoe, Receivers};
use crate::lanes::Lanes;
use nalgebra::Vector3;
use pulp::{Arch, Simd, WithSimd};
use rayon::prelude::*;
use std::f64::consts::PI;

/// Receivers that are gone through side by side.
const BLOCK: usize = 32;
/// Strips in a row that one thread goes through: the first side of each row is computed twice.
const STRIPS: usize = 6;

type Block = [f64; BLOCK];

/// The vortices of a strip, from its leading edge on.
struct Strip<'a> {
    vortices: &'a [Horseshoe],
    /// Where its legs leave: at the bound vortex itself, if they do not run along a surface.
    edges: [Vector3<f64>; 2],
    /// Radii of the cores of its sides.
    cores: [f64; 2],
}

/// Adds to a matrix, by its columns, `factor` times the incidence that each receiver's flow lacks for a unit `cp` of each box, -v.n/V.
pub(crate) fn add_strips(
    columns: Vec<&mut [f64]>,
    vortices: &[Horseshoe],
    receivers: &Receivers,
    factor: f64,
) {
    let blocks: Vec<Rows> =
        (0..receivers.len()).step_by(BLOCK).map(|first| Rows::of(receivers, first)).collect();
    let strips = strips(vortices);
    let mut columns = columns.into_iter();
    let tasks: Vec<Sum<'_, '_>> = strips
        .chunks(STRIPS)
        .map(|strips| {
            let count = strips.iter().map(|strip| strip.vortices.len()).sum();
            Sum { blocks: &blocks, strips, factor, columns: columns.by_ref().take(count).collect() }
        })
        .collect();
    tasks.into_par_iter().for_each(|sum| Arch::new().dispatch(sum));
}

fn strips(vortices: &[Horseshoe]) -> Vec<Strip<'_>> {
    let of_one = |a: &Horseshoe, b: &Horseshoe| a.edges.is_some() && a.edges == b.edges;
    let least = |vortices: &[Horseshoe]| vortices.iter().map(|v| v.core).fold(f64::INFINITY, f64::min);
    let mut strips: Vec<Strip<'_>> = vortices
        .chunk_by(of_one)
        .map(|vortices| {
            let edges = vortices[0].edges.unwrap_or([vortices[0].from, vortices[0].to]);
            Strip { vortices, edges, cores: [least(vortices); 2] }
        })
        .collect();
    for at in 1..strips.len() {
        let (before, after) = strips.split_at_mut(at);
        let (left, right) = (&mut before[at - 1], &mut after[0]);
        if left.meets(right) {
            let core = left.cores[1].min(right.cores[0]);
            (left.cores[1], right.cores[0]) = (core, core);
        }
    }
    strips
}

impl Strip<'_> {
    /// If its second side is the first one of another.
    fn meets(&self, other: &Strip<'_>) -> bool {
        let mut ends = self.vortices.iter().zip(other.vortices);
        self.vortices.len() == other.vortices.len()
            && self.edges[1] == other.edges[0]
            && ends.all(|(own, other)| own.to == other.from)
    }
}

/// Some receivers, the last ones repeated to fill a block.
struct Rows {
    first: usize,
    count: usize,
    point: [Block; 3],
    normal: [Block; 3],
    core: Block,
}

impl Rows {
    fn of(all: &Receivers, first: usize) -> Self {
        let count = BLOCK.min(all.len() - first);
        let block = |values: &[f64]| -> Block { std::array::from_fn(|at| values[first + at.min(count - 1)]) };
        Self {
            first,
            count,
            point: all.point.each_ref().map(|values| block(values)),
            normal: all.normal.each_ref().map(|values| block(values)),
            core: block(&all.core),
        }
    }
}

/// The end of a vortex as receivers see it.
#[derive(Clone, Copy)]
struct Seen {
    /// From it to them.
    r: [Block; 3],
    /// Its length, at least that of the core.
    l: Block,
    /// What a vortex of unit circulation gives their components that comes in to here from far downstream, times 4 pi.
    incoming: Block,
}

/// What strips in a row add to their columns.
struct Sum<'a, 'b> {
    blocks: &'a [Rows],
    strips: &'a [Strip<'a>],
    factor: f64,
    columns: Vec<&'b mut [f64]>,
}

impl WithSimd for Sum<'_, '_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(mut self, simd: S) {
        for rows in self.blocks {
            let mut columns = self.columns.iter_mut();
            // The ends on the side that was gone through last.
            let mut side: Vec<Seen> = Vec::new();
            for (at, strip) in self.strips.iter().enumerate() {
                if at == 0 || !self.strips[at - 1].meets(strip) {
                    let edge = rows.edge(simd, &strip.edges[0], strip.cores[0]);
                    side.clear();
                    for vortex in strip.vortices {
                        side.push(rows.first_end(simd, &edge, strip, vortex));
                    }
                }
                let edge = rows.edge(simd, &strip.edges[1], strip.cores[1]);
                for (vortex, end) in strip.vortices.iter().zip(&mut side) {
                    // As many columns as vortices.
                    let Some(column) = columns.next() else { return };
                    let mut given = [0.0; BLOCK];
                    rows.horseshoe(simd, &edge, strip, vortex, end, &mut given);
                    let scale = -self.factor * vortex.circulation / (4.0 * PI);
                    let column = &mut column[rows.first..rows.first + rows.count];
                    column.iter_mut().zip(&given).for_each(|(sum, given)| *sum += scale * given);
                }
            }
        }
    }
}

impl Rows {
    /// From a point to some of the receivers, and the distance, at least that of the core.
    #[inline(always)]
    fn from<S: Simd>(&self, simd: S, i: usize, point: &Vector3<f64>, core: Lanes<S>) -> Arm<S> {
        let [x, y, z] = &self.point;
        let r = [
            Lanes::load(simd, &x[i..]) - Lanes::all(simd, point.x),
            Lanes::load(simd, &y[i..]) - Lanes::all(simd, point.y),
            Lanes::load(simd, &z[i..]) - Lanes::all(simd, point.z),
        ];
        Arm { r, l: dot(&r, &r).sqrt().max(core) }
    }

    #[inline(always)]
    fn normal<S: Simd>(&self, simd: S, i: usize) -> [Lanes<S>; 3] {
        let [x, y, z] = &self.normal;
        [Lanes::load(simd, &x[i..]), Lanes::load(simd, &y[i..]), Lanes::load(simd, &z[i..])]
    }

    #[inline(always)]
    fn core<S: Simd>(&self, simd: S, i: usize, core: f64) -> Lanes<S> {
        Lanes::load(simd, &self.core[i..]).min(Lanes::all(simd, core))
    }

    /// Where the legs of a side leave, with what one gives that comes in there along the stream.
    #[inline(always)]
    fn edge<S: Simd>(&self, simd: S, edge: &Vector3<f64>, core: f64) -> Seen {
        let mut seen = Seen::nothing();
        for i in (0..BLOCK).step_by(Lanes::<S>::WIDTH) {
            let (core, normal) = (self.core(simd, i, core), self.normal(simd, i));
            let arm = self.from(simd, i, edge, core);
            let [x, y, z] = arm.r;
            // x_hat x r/(r (r - x)); downstream the quotient with the conjugate, where r - x would be a small difference.
            let behind = x.is_positive();
            let before = behind.same(1.0) - behind;
            let top = (arm.l + x) * behind + before;
            let bottom = (y * y + z * z).max(core * core) * behind + (arm.l - x) * before;
            let size = top * (bottom * arm.l).recip();
            seen.put(i, &arm, size * (z * normal[1] - y * normal[2]));
        }
        seen
    }

    /// The first end of a vortex, on the first side of its strip.
    #[inline(always)]
    fn first_end<S: Simd>(&self, simd: S, edge: &Seen, strip: &Strip<'_>, vortex: &Horseshoe) -> Seen {
        let mut seen = Seen::nothing();
        let length_2 = (vortex.from - strip.edges[0]).norm_squared();
        for i in (0..BLOCK).step_by(Lanes::<S>::WIDTH) {
            let (core, normal) = (self.core(simd, i, strip.cores[0]), self.normal(simd, i));
            let arm = self.from(simd, i, &vortex.from, core);
            let side = segment(&edge.arm(simd, i), &arm, &normal, core * core * length_2);
            seen.put(i, &arm, edge.incoming(simd, i) + side.top * side.bottom.recip());
        }
        seen
    }

    /// 4 pi times what a horseshoe of unit circulation gives: in along one side, through its bound segment, out along the other
    /// side. From its first end the one on the other side becomes.
    #[inline(always)]
    fn horseshoe<S: Simd>(
        &self,
        simd: S,
        edge: &Seen,
        strip: &Strip<'_>,
        vortex: &Horseshoe,
        end: &mut Seen,
        given: &mut Block,
    ) {
        let side_2 = (vortex.to - strip.edges[1]).norm_squared();
        let bound_2 = (vortex.to - vortex.from).norm_squared();
        for i in (0..BLOCK).step_by(Lanes::<S>::WIDTH) {
            let (core, normal) = (self.core(simd, i, strip.cores[1]), self.normal(simd, i));
            let arm = self.from(simd, i, &vortex.to, core);
            let side = segment(&edge.arm(simd, i), &arm, &normal, core * core * side_2);
            let core = self.core(simd, i, vortex.core);
            let bound = segment(&end.arm(simd, i), &arm, &normal, core * core * bound_2);
            // One division for both: they are what takes the time here.
            let one_over_both = (side.bottom * bound.bottom).recip();
            let incoming = edge.incoming(simd, i) + side.top * bound.bottom * one_over_both;
            let through = end.incoming(simd, i) + bound.top * side.bottom * one_over_both;
            (through - incoming).store(&mut given[i..]);
            end.put(i, &arm, incoming);
        }
    }
}

impl Seen {
    fn nothing() -> Self {
        Self { r: [[0.0; BLOCK]; 3], l: [0.0; BLOCK], incoming: [0.0; BLOCK] }
    }

    #[inline(always)]
    fn put<S: Simd>(&mut self, i: usize, arm: &Arm<S>, incoming: Lanes<S>) {
        arm.r[0].store(&mut self.r[0][i..]);
        arm.r[1].store(&mut self.r[1][i..]);
        arm.r[2].store(&mut self.r[2][i..]);
        arm.l.store(&mut self.l[i..]);
        incoming.store(&mut self.incoming[i..]);
    }

    #[inline(always)]
    fn arm<S: Simd>(&self, simd: S, i: usize) -> Arm<S> {
        let [x, y, z] = &self.r;
        let r = [Lanes::load(simd, &x[i..]), Lanes::load(simd, &y[i..]), Lanes::load(simd, &z[i..])];
        Arm { r, l: Lanes::load(simd, &self.l[i..]) }
    }

    #[inline(always)]
    fn incoming<S: Simd>(&self, simd: S, i: usize) -> Lanes<S> {
        Lanes::load(simd, &self.incoming[i..])
    }
}

/// From an end to receivers, and the distance, at least that of the core.
struct Arm<S: Simd> {
    r: [Lanes<S>; 3],
    l: Lanes<S>,
}

/// A quotient.
struct Quotient<S: Simd> {
    top: Lanes<S>,
    bottom: Lanes<S>,
}

/// 4 pi times the component of the velocity of a segment of circulation 1, seen from its ends; the least square of its cross
/// product is that at the core.
#[inline(always)]
fn segment<S: Simd>(from: &Arm<S>, to: &Arm<S>, normal: &[Lanes<S>; 3], least: Lanes<S>) -> Quotient<S> {
    let (r1, r2) = (&from.r, &to.r);
    let cross = [r1[1] * r2[2] - r1[2] * r2[1], r1[2] * r2[0] - r1[0] * r2[2], r1[0] * r2[1] - r1[1] * r2[0]];
    let (product, along) = (from.l * to.l, dot(r1, r2));
    // 1/(product + along); beside the segment the quotient with the conjugate, where that would be a small difference.
    let beyond = along.is_positive();
    let beside = beyond.same(1.0) - beyond;
    let top = (product - along) * beside + beyond;
    let bottom = dot(&cross, &cross).max(least) * beside + (product + along) * beyond;
    Quotient { top: dot(&cross, normal) * (from.l + to.l) * top, bottom: product * bottom }
}

#[inline(always)]
fn dot<S: Simd>(a: &[Lanes<S>; 3], b: &[Lanes<S>; 3]) -> Lanes<S> {
    a[0].times_plus(b[0], a[1].times_plus(b[1], a[2] * b[2]))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::horseshoe::tests::{biot_savart, line, points_about, vortex};

    /// 4 pi times the velocities that vortices of circulation 1 give a point, one column after the other.
    fn velocities(vortices: &[Horseshoe], point: &Vector3<f64>, core: f64) -> Vec<Vector3<f64>> {
        let mut receivers = Receivers::default();
        for axis in 0..3 {
            receivers.point[axis] = vec![point[axis]; 3];
            receivers.normal[axis] = (0..3).map(|of| f64::from(u8::from(of == axis))).collect();
        }
        receivers.core = vec![core; 3];
        let mut columns = vec![vec![0.0; 3]; vortices.len()];
        let slices = columns.iter_mut().map(Vec::as_mut_slice).collect();
        add_strips(slices, vortices, &receivers, -4.0 * PI);
        columns.iter().map(|column| Vector3::from_column_slice(column)).collect()
    }

    #[test]
    fn horseshoes_along_the_stream_or_the_surface_obey_biot_and_savart() {
        let own = vortex([0.3, -0.4, 0.1], [0.5, 0.7, 0.3]);
        let edges = [Vector3::new(1.1, -0.5, -0.1), Vector3::new(1.4, 0.8, 0.2)];
        for (edges, along) in [(None, [own.from + Vector3::x(), own.to + Vector3::x()]), (Some(edges), edges)]
        {
            let mut own = own;
            own.edges = edges;
            for point in points_about(&own, &along) {
                let got = velocities(&[own], &point, 1e-6)[0];
                let want = biot_savart(&line(&own, along), &point);
                assert!((got - want).norm() < 1e-6 * (1e-3 + want.norm()), "{point}: {got} {want}");
            }
        }
    }

    /// In the middle of a long side 4 pi v = 2/rho outside of the core and 2 rho/core² in it, round the
    /// side's direction.
    #[test]
    fn sides_along_the_surface_have_a_core() {
        let (long, core) = (1e6, 0.01);
        let direction = Vector3::new(0.8, 0.0, 0.6);
        for side in [0, 1] {
            let mut ends = [[0.0, 0.0, 0.0], [0.0, 0.0, 0.0]].map(Vector3::from);
            ends[1 - side].y = if side == 0 { 1e12 } else { -1e12 };
            let mut own = vortex((ends[0] - direction * long).into(), (ends[1] - direction * long).into());
            own.edges = Some([ends[0] + direction * long, ends[1] + direction * long]);
            // It comes in along side 1 and goes out along side 2.
            let along = if side == 0 { -direction } else { direction };
            for rho in [1e-4, 0.002, 0.0099, 0.0101, 0.02, 1.0] {
                for away in [Vector3::y(), direction.cross(&Vector3::y())] {
                    let r = away * rho;
                    let got = velocities(&[own], &r, core)[0];
                    let want = along.cross(&r) * 2.0 / f64::max(rho * rho, core * core);
                    assert!((got - want).norm() < 1e-3 * want.norm(), "side {side} at {rho}: {got} {want}");
                }
            }
        }
    }

    /// Strips that meet, and some that do not: of fewer vortices, with other ends, with other edges.
    #[test]
    fn a_strip_gives_what_it_gives_alone_whether_or_not_another_meets_it() {
        let corner = |strip: usize, x: f64, z: f64| {
            let y = strip as f64;
            Vector3::new(x + 0.1 * y, 0.5 * y, z + 0.05 * y * y)
        };
        let strip = |(at, (chordwise, [ends, edges])): (usize, (usize, [f64; 2]))| -> Vec<Horseshoe> {
            let one = |i: usize| {
                let x = 0.3 * i as f64;
                let mut own = vortex(corner(at, x, ends).into(), corner(at + 1, x, ends).into());
                own.edges = Some([corner(at, 1.0, edges), corner(at + 1, 1.0, edges)]);
                (own.circulation, own.core) = (1.0 + i as f64, 1.0 + at as f64);
                own
            };
            (0..chordwise).map(one).collect()
        };
        let moved = [(2, [0.0, 0.0]), (2, [0.3, 0.0]), (2, [0.3, 0.1]), (2, [0.3, 0.1])];
        let strips: Vec<Vec<Horseshoe>> =
            vec![(3, [0.0, 0.0]); 8].into_iter().chain(moved).enumerate().map(strip).collect();
        let all: Vec<Horseshoe> = strips.concat();
        let split = super::strips(&all);
        assert_eq!(split.len(), strips.len());
        let meet: Vec<bool> = split.windows(2).map(|pair| pair[0].meets(&pair[1])).collect();
        assert_eq!(meet, [[true; 7].as_slice(), &[false; 3], &[true]].concat());
        assert_eq!([0, 1, 7, 8].map(|at| split[at].cores), [[1.0, 1.0], [1.0, 2.0], [7.0, 8.0], [9.0, 9.0]]);
        for point in [Vector3::new(0.7, 1.1, 0.2), Vector3::new(3.0, -0.4, 0.5)] {
            let alone: Vec<_> = strips.iter().flat_map(|strip| velocities(strip, &point, 1e-3)).collect();
            for (own, alone) in velocities(&all, &point, 1e-3).iter().zip(&alone) {
                assert!((own - alone).norm() < 1e-13 * alone.norm(), "{own} {alone}");
            }
        }
    }
}
