//! Velocity of a horseshoe vortex: a bound segment and two legs along +x to infinity (Biot-Savart).
//!
//! With r1, r2 from the segment's ends to the point, a segment of circulation 1 induces
//! `(r1 x r2) (|r1|+|r2|) / (4 pi |r1||r2| (|r1||r2| + r1.r2))`, a leg from r = 0 along +x
//! `(x_hat x r) / (4 pi |r| (|r| - x))` (Katz and Plotkin, Low-Speed Aerodynamics, section 10.4.5, rearranged).
//! Both are singular on the vortex itself only, not on its extension. Where the last factor would be a small
//! difference it is replaced by the quotient with its conjugate, so that nothing cancels.
//!
//! On the vortex: each segment has a core of [`CORE`] times the smaller of the two boxes' sizes, within which its
//! velocity falls linearly to zero on the line. A point on the line therefore gets nothing from that segment (the
//! principal value) and all of the other two; and because the core is relative, size does not matter. Control
//! points of a panel are half a box from every vortex of it, so cores act only between surfaces, as when a tail
//! stands in line with the strip edges of a wing.

#![expect(clippy::inline_always, reason = "a call would leave the vector instructions of the loop around it")]

use crate::geometry::AeroBox;
use crate::lattice::Lattice;
use nalgebra::{Point3, Vector3};
use pulp::{Arch, Simd, WithSimd};
use std::f64::consts::PI;

/// Radius of a vortex core over the size (smaller of chord and width) of the smaller of the two boxes involved.
///
/// Large enough to hide the rounding of 8-character fields of a deck, small beside half a box.
pub const CORE: f64 = 0.01;

/// One horseshoe of unit strength in `cp`: circulation `V chord/2`.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Horseshoe {
    /// Ends of its legs on the surface, where these do not run along x from the bound segment on.
    pub(crate) edges: Option<[Vector3<f64>; 2]>,
    pub(crate) from: Vector3<f64>,
    pub(crate) to: Vector3<f64>,
    length_2: f64,
    pub(crate) core: f64,
    pub(crate) circulation: f64,
}

impl Horseshoe {
    /// The horseshoe of a box whose bound vortex is that of `at`, its x stretched by `1/beta` (Prandtl-Glauert).
    fn new(panel: &AeroBox, at: &AeroBox, beta: f64) -> Self {
        let [from, to] = at.bound_vortex().map(|p| stretched(&p, beta));
        Self {
            edges: None,
            from,
            to,
            length_2: (to - from).norm_squared(),
            core: core(panel),
            circulation: panel.chord_m() / 2.0,
        }
    }
}

/// Points that receive velocity, each with the direction of which the component is taken.
///
/// One array for each number, so that the loop over points is straight and wide.
#[derive(Debug, Clone, Default)]
pub(crate) struct Receivers {
    pub(crate) point: [Vec<f64>; 3],
    pub(crate) normal: [Vec<f64>; 3],
    pub(crate) core: Vec<f64>,
}

impl Receivers {
    pub(crate) fn len(&self) -> usize {
        self.core.len()
    }

    /// Three-quarter points and normals of the boxes, x stretched by `1/beta`; mirrored about `plane` if given.
    ///
    /// The velocity of a vortex's image along n is that of the vortex itself, at the mirrored point, along the
    /// mirrored n: so points are mirrored, not vortices.
    pub(crate) fn new(lattice: &Lattice, beta: f64, plane: Option<f64>) -> Self {
        let mut all = Self::default();
        for panel in &lattice.boxes {
            let (mut p, mut n) = (stretched(&panel.three_quarter_point(), beta), panel.normal());
            if let Some(y_m) = plane {
                p.y = 2.0 * y_m - p.y;
                n.y = -n.y;
            }
            for axis in 0..3 {
                all.point[axis].push(p[axis]);
                all.normal[axis].push(n[axis]);
            }
            all.core.push(core(panel));
        }
        all
    }

    /// Adds `factor` times the incidence that each receiver's flow lacks for a unit `cp` of one box, -v.n/V; the legs run along x.
    pub(crate) fn add_incidence(&self, vortex: &Horseshoe, factor: f64, out: &mut [f64]) {
        let scale = -factor * vortex.circulation / (4.0 * PI);
        Arch::new().dispatch(Sum { to: self, of: vortex, scale, out });
    }
}

/// A sum over receivers. No closure: the compiler puts a call around one, which is not compiled for the vector instructions found.
struct Sum<'a> {
    to: &'a Receivers,
    of: &'a Horseshoe,
    scale: f64,
    out: &'a mut [f64],
}

impl WithSimd for Sum<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) {
        // Equal lengths known to the compiler: no bounds checks inside.
        let (count, Self { to, of, scale, out }) = (self.out.len(), self);
        let [px, py, pz] = to.point.each_ref().map(|values| &values[..count]);
        let [nx, ny, nz] = to.normal.each_ref().map(|values| &values[..count]);
        let (cores, vortex) = (&to.core[..count], *of);
        for i in 0..count {
            let v = velocity(&vortex, [px[i], py[i], pz[i]], cores[i].min(vortex.core));
            out[i] += scale * (v[0] * nx[i] + v[1] * ny[i] + v[2] * nz[i]);
        }
    }
}

/// The horseshoes of all boxes, x stretched by `1/beta`.
pub(crate) fn horseshoes(lattice: &Lattice, beta: f64) -> Vec<Horseshoe> {
    lattice.boxes.iter().map(|panel| Horseshoe::new(panel, panel, beta)).collect()
}

/// The horseshoes of boxes that stand at an angle to the stream or to each other: they run along the corners of the same boxes `closed`
/// (joined where they meet), their legs along the sides of the strip to its trailing edge, and leave it along the stream.
pub(crate) fn horseshoes_on_surfaces(lattice: &Lattice, closed: &Lattice, beta: f64) -> Vec<Horseshoe> {
    let boxes = lattice.boxes.iter().zip(&closed.boxes);
    let mut all: Vec<Horseshoe> = boxes.map(|(panel, at)| Horseshoe::new(panel, at, beta)).collect();
    for surface in &lattice.surfaces {
        for at in 0..surface.spanwise * surface.chordwise {
            let last = surface.first_box + at - at % surface.chordwise + surface.chordwise - 1;
            let [_, side_1, side_2, _] = &closed.boxes[last].corners;
            let vortex = &mut all[surface.first_box + at];
            vortex.edges = Some([stretched(side_1, beta), stretched(side_2, beta)]);
        }
    }
    all
}

pub(crate) fn stretched(p: &Point3<f64>, beta: f64) -> Vector3<f64> {
    Vector3::new(p.x / beta, p.y, p.z)
}

/// Radius of the core of a box's vortices, m.
pub(crate) fn core(panel: &AeroBox) -> f64 {
    CORE * panel.chord_m().min(panel.width_m())
}

/// From an end of a segment to a point, and its length, at least that of the core.
#[inline(always)]
fn seen_from(end: &Vector3<f64>, point: [f64; 3], core: f64) -> ([f64; 3], f64) {
    let r = [point[0] - end.x, point[1] - end.y, point[2] - end.z];
    (r, (r[0] * r[0] + r[1] * r[1] + r[2] * r[2]).sqrt().max(core))
}

/// 4 pi times the velocity of a segment of circulation 1, seen from its ends.
#[inline(always)]
fn segment((r1, l1): ([f64; 3], f64), (r2, l2): ([f64; 3], f64), length_2: f64, core_2: f64) -> [f64; 3] {
    let cross = [r1[1] * r2[2] - r1[2] * r2[1], r1[2] * r2[0] - r1[0] * r2[2], r1[0] * r2[1] - r1[1] * r2[0]];
    let cross_2 = cross[0] * cross[0] + cross[1] * cross[1] + cross[2] * cross[2];
    let (product, dot) = (l1 * l2, r1[0] * r2[0] + r1[1] * r2[1] + r1[2] * r2[2]);
    // One division: they are what takes the time here.
    let (top, bottom) =
        if dot < 0.0 { (product - dot, cross_2.max(core_2 * length_2)) } else { (1.0, product + dot) };
    let size = (l1 + l2) * top / (product * bottom);
    cross.map(|component| component * size)
}

/// 4 pi times the velocity of a horseshoe of circulation 1 at a point.
#[inline(always)]
fn velocity(vortex: &Horseshoe, point: [f64; 3], core: f64) -> [f64; 3] {
    let (from, to) = (seen_from(&vortex.from, point, core), seen_from(&vortex.to, point, core));
    let bound = segment(from, to, vortex.length_2, core * core);
    with_legs(bound, from, to, core)
}

/// With what legs along +x add that come in at one end and leave at the other.
#[inline(always)]
fn with_legs(v: [f64; 3], (r1, l1): ([f64; 3], f64), (r2, l2): ([f64; 3], f64), core: f64) -> [f64; 3] {
    let core_2 = core * core;
    let leg_1 = leg(r1[0], r1[1] * r1[1] + r1[2] * r1[2], l1, core_2);
    let leg_2 = leg(r2[0], r2[1] * r2[1] + r2[2] * r2[2], l2, core_2);
    [v[0], v[1] - leg_2 * r2[2] + leg_1 * r1[2], v[2] + leg_2 * r2[1] - leg_1 * r1[1]]
}

/// Factor of `x_hat x r` for a leg along +x: `1/(r (r - x))`.
#[inline(always)]
fn leg(x: f64, rho_2: f64, r: f64, core_2: f64) -> f64 {
    // Multiplying by 1 = (r + x)/(r + x) downstream avoids the difference r - x.
    let (top, bottom) = if x > 0.0 { (r + x, rho_2.max(core_2)) } else { (1.0, r - x) };
    top / (bottom * r)
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;

    pub(crate) fn vortex(from: [f64; 3], to: [f64; 3]) -> Horseshoe {
        let (from, to) = (Vector3::from(from), Vector3::from(to));
        Horseshoe { edges: None, from, to, length_2: (to - from).norm_squared(), core: 1.0, circulation: 1.0 }
    }

    /// Far downstream a leg is a straight vortex: 4 pi v = 2/rho outside of the core, and 2 rho/core² in it (Rankine).
    #[test]
    fn a_leg_is_a_vortex_with_a_core_that_turns_as_a_solid_body() {
        // the other leg is so far away that it adds nothing
        let far = vortex([0.0, 0.0, 0.0], [0.0, 1e12, 0.0]);
        let core = 0.01;
        for rho in [1e-4, 0.002, 0.005, 0.0099, 0.0101, 0.02, 1.0] {
            let expected = if rho < core { 2.0 * rho / (core * core) } else { 2.0 / rho };
            let near = |got: f64, want: f64| {
                assert!((got - want).abs() < 1e-5 * expected, "{rho}: {got}, not {want}");
            };
            let [_, v, w] = velocity(&far, [1e7, rho, 0.0], core);
            near(w, -expected);
            near(v, 0.0);
            let [_, v, w] = velocity(&far, [1e7, 0.0, rho], core);
            near(v, expected);
            near(w, 0.0);
        }
    }

    /// In the middle of a long bound segment 4 pi v = 2/rho outside of the core, and linear to zero on the line.
    #[test]
    fn a_bound_segment_has_the_same_core() {
        let long = vortex([0.0, -1e4, 0.0], [0.0, 1e4, 0.0]);
        let core = 0.01;
        for rho in [1e-4, 0.002, 0.005, 0.0099, 0.0101, 0.02, 1.0] {
            let expected = if rho < core { 2.0 * rho / (core * core) } else { 2.0 / rho };
            let [u, ..] = velocity(&long, [0.0, 0.0, rho], core);
            assert!((u - expected).abs() < 1e-5 * expected, "{rho}: {u}, not {expected}");
        }
        // on the line itself: nothing from the segment, all of both legs, each a half vortex at its distance
        let [u, v, w] = velocity(&vortex([0.0, -2.0, 0.0], [0.0, 1.0, 0.0]), [0.0, 0.0, 0.0], core);
        assert_eq!((u, v), (0.0, 0.0));
        assert!((w + (1.0 / 2.0 + 1.0 / 1.0)).abs() < 1e-12, "{w}");
    }

    /// The core is a hundredth of the least of both boxes' chords and widths.
    #[test]
    fn the_core_is_that_of_the_smaller_box() {
        let trapezoid = |id: u32, x: f64, y: f64, chord: f64, width: f64| {
            crate::Lattice::trapezoid(id, [x, y, 0.0], chord, [x, y + width, 0.0], chord, [1, 1])
                .expect("a box")
        };
        // the receiver's three-quarter point is 0.001 m beside the right leg of the sender, far downstream of it
        for (chord, width) in [(2.0, 0.5), (0.4, 2.0), (0.05, 3.0), (3.0, 0.05)] {
            let sender = trapezoid(1, 0.0, 0.0, 2.0, 1.0);
            let receiver = trapezoid(2, 1e4, 1.001 - 0.5 * width, chord, width);
            let mut incidence = [0.0];
            Receivers::new(&receiver, 1.0, None).add_incidence(
                &horseshoes(&sender, 1.0)[0],
                1.0,
                &mut incidence,
            );
            let core = 0.01 * f64::min(1.0, f64::min(chord, width));
            let rho = 0.001;
            let right = if rho < core { 2.0 * rho / (core * core) } else { 2.0 / rho };
            // outside of both legs: the right one blows up, the left one down; circulation V chord/2
            let expected = -(right - 2.0 / 1.001) * 1.0 / (4.0 * PI);
            assert!(
                (incidence[0] / expected - 1.0).abs() < 1e-4,
                "{chord} {width}: {} {expected}",
                incidence[0]
            );
        }
    }

    /// Biot and Savart's law for the pieces of a line by Simpson's rule: 4 pi times the velocity of circulation 1.
    pub(crate) fn biot_savart(line: &[Vector3<f64>], point: &Vector3<f64>) -> Vector3<f64> {
        let parts = 4000_u32;
        let of = |ends: &[Vector3<f64>]| -> Vector3<f64> {
            let along = ends[1] - ends[0];
            let one = |i: u32| {
                let weight = if i == 0 || i == parts { 1.0 } else { f64::from(2 + 2 * (i % 2)) };
                let r = point - (ends[0] + along * (f64::from(i) / f64::from(parts)));
                along.cross(&r) * (weight / r.norm().powi(3))
            };
            (0..=parts).map(one).sum::<Vector3<f64>>() / (3.0 * f64::from(parts))
        };
        line.windows(2).map(of).sum()
    }

    /// The corners of a horseshoe whose legs leave the surface at `edges`, from far downstream to far downstream.
    pub(crate) fn line(vortex: &Horseshoe, edges: [Vector3<f64>; 2]) -> Vec<Vector3<f64>> {
        let away = |edge: Vector3<f64>| [3.0, 10.0, 100.0, 1e3, 1e4, 1e5].map(|x| edge + Vector3::x() * x);
        let mut all: Vec<_> = away(edges[0]).into_iter().rev().collect();
        all.extend([edges[0], vortex.from, vortex.to, edges[1]]);
        all.extend(away(edges[1]));
        all
    }

    /// Points about a horseshoe, and on the extensions of its bound line, of its sides and, upstream, of its legs: nothing comes of
    /// these themselves.
    pub(crate) fn points_about(own: &Horseshoe, edges: &[Vector3<f64>; 2]) -> Vec<Vector3<f64>> {
        let mut points: Vec<Vector3<f64>> = Vec::new();
        for x in [-30.0, -0.6, 0.4, 0.9, 2.5] {
            points.extend(
                [[-1.3, 0.5], [0.2, -0.6], [0.4, 0.9], [2.1, 0.1]].map(|[y, z]| Vector3::new(x, y, z)),
            );
        }
        points.extend([own.to + (own.to - own.from) * 0.8, own.from + (own.from - own.to) * 1.5]);
        points.extend([edges[0] + (edges[0] - own.from), own.from + (own.from - edges[0]) * 0.7]);
        points.extend([own.to - Vector3::x() * 0.9, edges[1] - Vector3::x() * 2.0]);
        points
    }

    #[test]
    fn horseshoes_obey_biot_and_savart() {
        let own = vortex([0.3, -0.4, 0.1], [0.5, 0.7, 0.3]);
        let straight = [own.from + Vector3::x(), own.to + Vector3::x()];
        for point in points_about(&own, &straight) {
            let got = Vector3::from(velocity(&own, point.into(), 1e-6));
            let want = biot_savart(&line(&own, straight), &point);
            assert!((got - want).norm() < 1e-6 * (1e-3 + want.norm()), "{point}: {got} {want}");
        }
    }
}
