//! What horseshoe vortices give a point, and how that changes as their ends move; [`crate::horseshoe`]'s velocities term by term.

#![expect(clippy::inline_always, reason = "a call would leave the vector instructions of the loop around it")]

use crate::horseshoe::Horseshoe;
use pulp::{Arch, Simd, WithSimd};
use std::f64::consts::PI;

/// Of a vortex: leg's end, bound segment's two ends, leg's end.
pub(super) const ENDS: usize = 4;
/// Vortices that are gone through side by side.
pub(super) const BLOCK: usize = 32;

/// Vortices with their pressures, one array for each number, so that the loop over them is straight and wide; the last block is
/// filled up with vortices of no strength.
pub(super) struct Block {
    /// Ends by coordinate, x stretched.
    points: [[[f64; BLOCK]; 3]; ENDS],
    core: [f64; BLOCK],
    /// Circulation over -4 pi.
    strength: [f64; BLOCK],
}

/// A point and what it receives of all vortices, in as many sums as a block has vortices.
pub(super) struct Receiver {
    point: [f64; 3],
    /// The direction along which velocities count.
    along: [f64; 3],
    core: f64,
    /// Velocity by coordinate, strengths included.
    velocity: [[f64; BLOCK]; 3],
    /// Derivatives of its component by the ends, all of them together.
    by_ends: [[f64; BLOCK]; 3],
}

/// What points of all sides receive of the vortices of a block, strengths included.
pub(super) struct Seen {
    /// The components of the velocities.
    pub(super) incidence: [f64; BLOCK],
    /// Their derivatives by the ends, by coordinate.
    pub(super) by_end: [[[f64; BLOCK]; 3]; ENDS],
}

impl Receiver {
    pub(super) fn new(point: [f64; 3], along: [f64; 3], core: f64) -> Self {
        let nothing = [[0.0; BLOCK]; 3];
        Self { point, along, core, velocity: nothing, by_ends: nothing }
    }

    /// Velocity, strengths included.
    pub(super) fn velocity(&self) -> [f64; 3] {
        self.velocity.each_ref().map(|parts| parts.iter().sum())
    }

    /// Derivatives of its component by the point: all ends stay.
    pub(super) fn by_point(&self) -> [f64; 3] {
        self.by_ends.each_ref().map(|parts| -parts.iter().sum::<f64>())
    }
}

impl Seen {
    pub(super) fn nothing() -> Self {
        Self { incidence: [0.0; BLOCK], by_end: [[[0.0; BLOCK]; 3]; ENDS] }
    }
}

impl Block {
    pub(super) fn new(vortices: &[Horseshoe], cp: &[f64]) -> Self {
        let mut all = Self { points: [[[0.0; BLOCK]; 3]; ENDS], core: [1.0; BLOCK], strength: [0.0; BLOCK] };
        for (l, (vortex, cp)) in vortices.iter().zip(cp).enumerate() {
            let [edge_1, edge_2] = vortex.edges.unwrap_or([vortex.from, vortex.to]);
            for (points, end) in all.points.iter_mut().zip([edge_1, vortex.from, vortex.to, edge_2]) {
                points.iter_mut().zip(end.iter()).for_each(|(values, value)| values[l] = *value);
            }
            all.core[l] = vortex.core;
            all.strength[l] = -cp * vortex.circulation / (4.0 * PI);
        }
        all
    }

    /// Adds what the vortices give a point.
    pub(super) fn add_to(&self, receiver: &mut Receiver, seen: &mut Seen) {
        Arch::new().dispatch(Given { block: self, receiver, seen });
    }
}

/// A type with a method of its own, no closure: as in [`crate::horseshoe`].
struct Given<'a> {
    block: &'a Block,
    receiver: &'a mut Receiver,
    seen: &'a mut Seen,
}

impl WithSimd for Given<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) {
        let Self { block, receiver, seen } = self;
        let (point, along, own_core) = (receiver.point, receiver.along, receiver.core);
        // Arrays of its own, which nothing else can point at: the compiler puts the loop side by side.
        let (mut velocity, mut by_end) = ([[0.0; BLOCK]; 3], [[[0.0; BLOCK]; 3]; ENDS]);
        for l in 0..BLOCK {
            let r = block
                .points
                .each_ref()
                .map(|end| [point[0] - end[0][l], point[1] - end[1][l], point[2] - end[2][l]]);
            let strength = block.strength[l];
            let (unit, by) = horseshoe(&r, scaled(along, strength), own_core.min(block.core[l]));
            for axis in 0..3 {
                velocity[axis][l] = unit[axis] * strength;
                for (all, one) in by_end.iter_mut().zip(&by) {
                    all[axis][l] = one[axis];
                }
            }
        }
        for axis in 0..3 {
            for l in 0..BLOCK {
                receiver.velocity[axis][l] += velocity[axis][l];
                seen.incidence[l] += along[axis] * velocity[axis][l];
                for (all, one) in seen.by_end.iter_mut().zip(&by_end) {
                    receiver.by_ends[axis][l] += one[axis][l];
                    all[axis][l] += one[axis][l];
                }
            }
        }
    }
}

/// A vector from a vortex's end to a point.
#[derive(Clone, Copy)]
struct Arm {
    r: [f64; 3],
    /// Its length, at least that of the core, and one over that. Divisions are what takes the time here.
    l: f64,
    one_over_l: f64,
    /// Derivative of the length: the direction outside of the core.
    by_r: [f64; 3],
}

impl Arm {
    #[inline(always)]
    fn new(r: [f64; 3], core: f64) -> Self {
        let length = dot(r, r).sqrt();
        let l = length.max(core);
        let one_over_l = 1.0 / l;
        let by_r = scaled(r, if length > core { one_over_l } else { 0.0 });
        Self { r, l, one_over_l, by_r }
    }
}

/// A horseshoe seen from its ends: 4 pi times the velocity of unit circulation, and the derivatives of its weighted sum by the
/// places of the ends.
#[inline(always)]
fn horseshoe(r: &[[f64; 3]; ENDS], weights: [f64; 3], core: f64) -> ([f64; 3], [[f64; 3]; ENDS]) {
    let arms = [Arm::new(r[0], core), Arm::new(r[1], core), Arm::new(r[2], core), Arm::new(r[3], core)];
    // Circulation comes in along side 1, runs along the bound segment, and leaves along side 2. Where a side has no length, its
    // derivatives are those of one place and cancel.
    let (side_1, by_1) = segment(arms[0], arms[1], weights, core);
    let (bound, by_2) = segment(arms[1], arms[2], weights, core);
    let (side_2, by_3) = segment(arms[2], arms[3], weights, core);
    let (leg_1, by_leg_1) = leg(arms[0], weights, core);
    let (leg_2, by_leg_2) = leg(arms[3], weights, core);
    let sides = added(added(side_1, bound), side_2);
    // r runs from the ends.
    let by_ends = [
        taken(by_leg_1, by_1[0]),
        scaled(added(by_1[1], by_2[0]), -1.0),
        scaled(added(by_2[1], by_3[0]), -1.0),
        scaled(added(by_3[1], by_leg_2), -1.0),
    ];
    (added(sides, taken(leg_2, leg_1)), by_ends)
}

/// A segment seen from its ends: velocity, and the derivatives of its weighted sum by both vectors.
#[inline(always)]
fn segment(from: Arm, to: Arm, weights: [f64; 3], core: f64) -> ([f64; 3], [[f64; 3]; 2]) {
    let (r1, r2) = (from.r, to.r);
    let (across, product, along) = (cross(r1, r2), from.l * to.l, dot(r1, r2));
    let apart = taken(r1, r2);
    let least = core * core * dot(apart, apart);
    let (top, bottom) =
        if along < 0.0 { (product - along, dot(across, across).max(least)) } else { (1.0, product + along) };
    let one_over_sum = top / bottom;
    let (lengths, one_over_product) = (from.l + to.l, from.one_over_l * to.one_over_l);
    let one_over_lengths = 1.0 / lengths;
    let size = lengths * one_over_product * one_over_sum;
    let weighted = dot(weights, across) * size;
    let by_1 = scaled(from.by_r, one_over_lengths - to.l * (one_over_product + one_over_sum));
    let by_2 = scaled(to.by_r, one_over_lengths - from.l * (one_over_product + one_over_sum));
    let by_1 = scaled(taken(by_1, scaled(r2, one_over_sum)), weighted);
    let by_2 = scaled(taken(by_2, scaled(r1, one_over_sum)), weighted);
    let by_1 = added(scaled(cross(r2, weights), size), by_1);
    let by_2 = added(scaled(cross(weights, r1), size), by_2);
    (scaled(across, size), [by_1, by_2])
}

/// A leg along +x seen from its end: velocity, and the derivative of its weighted sum.
#[inline(always)]
fn leg(from: Arm, weights: [f64; 3], core: f64) -> ([f64; 3], [f64; 3]) {
    let ([x, y, z], l) = (from.r, from.l);
    let rho_2 = (y * y + z * z).max(core * core);
    let (top, bottom) = if x > 0.0 { (l + x, rho_2) } else { (1.0, l - x) };
    let size = top / bottom * from.one_over_l;
    let weighted = weights[2] * y - weights[1] * z;
    let by_radius = -size * size * (2.0 * l - x) * from.one_over_l;
    let by_size = [from.one_over_l * from.one_over_l * from.one_over_l, by_radius * y, by_radius * z];
    let turned = [0.0, weights[2] * size, -weights[1] * size];
    ([0.0, -z * size, y * size], added(turned, scaled(by_size, weighted)))
}

#[inline(always)]
fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

#[inline(always)]
fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

#[inline(always)]
fn added(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

#[inline(always)]
fn taken(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

#[inline(always)]
fn scaled(a: [f64; 3], by: f64) -> [f64; 3] {
    [a[0] * by, a[1] * by, a[2] * by]
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::Vector3;

    fn segment_of(
        r1: &Vector3<f64>,
        r2: &Vector3<f64>,
        weights: &Vector3<f64>,
        core: f64,
    ) -> (Vector3<f64>, [Vector3<f64>; 2]) {
        let (velocity, by) =
            segment(Arm::new((*r1).into(), core), Arm::new((*r2).into(), core), (*weights).into(), core);
        (velocity.into(), by.map(Vector3::from))
    }

    fn leg_of(r: &Vector3<f64>, weights: &Vector3<f64>, core: f64) -> (Vector3<f64>, Vector3<f64>) {
        let (velocity, by) = leg(Arm::new((*r).into(), core), (*weights).into(), core);
        (velocity.into(), by.into())
    }

    /// How a number changes as a vector does, by central differences.
    fn differences(of: impl Fn(&Vector3<f64>) -> f64, at: &Vector3<f64>) -> Vector3<f64> {
        let step = 1e-5 * at.norm();
        Vector3::from_fn(|axis, _| {
            let [up, down] = [step, -step].map(|step| {
                let mut there = *at;
                there[axis] += step;
                of(&there)
            });
            (up - down) / (2.0 * step)
        })
    }

    /// Biot and Savart: (r1 x r2) (1/|r1| + 1/|r2|)/(|r1||r2| + r1.r2), where that is no small difference.
    #[test]
    fn a_segment_has_its_velocity_and_the_derivatives_by_its_ends() {
        let (core, weights) = (1e-3, Vector3::new(0.3, -0.7, 0.5));
        for (r1, r2) in [
            ([0.4, 0.2, -0.1], [-0.5, 0.7, 0.3]),
            ([-0.4, 0.5, 0.2], [0.6, 0.1, 0.4]),
            ([1.0, 0.3, 0.0], [-1.2, 0.2, 0.1]),
            ([2.0, -0.7, 0.4], [1.1, 0.5, 0.3]),
            // beyond either end on the segment's line, and within the core of the nearer end
            ([0.3, 0.4, -0.2], [0.9, 1.2, -0.6]),
            ([0.9, 1.2, -0.6], [0.3, 0.4, -0.2]),
            ([2e-4, 3e-4, 1e-4], [0.8, 0.5, 0.1]),
            ([0.8, 0.5, 0.1], [2e-4, -3e-4, 1e-4]),
        ] {
            let (r1, r2) = (Vector3::from(r1), Vector3::from(r2));
            let (velocity, [by_1, by_2]) = segment_of(&r1, &r2, &weights, core);
            let (l1, l2) = (r1.norm().max(core), r2.norm().max(core));
            let want = r1.cross(&r2) * ((1.0 / l1 + 1.0 / l2) / (l1 * l2 + r1.dot(&r2)));
            assert!((velocity - want).norm() < 1e-12 * (1.0 + want.norm()), "{velocity} {want}");
            let of = |a: &Vector3<f64>, b: &Vector3<f64>| weights.dot(&segment_of(a, b, &weights, core).0);
            let (want_1, want_2) = (differences(|r| of(r, &r2), &r1), differences(|r| of(&r1, r), &r2));
            let size = 1.0 + want_1.norm() + want_2.norm();
            assert!((by_1 - want_1).norm() < 1e-7 * size, "{r1} {r2}: {by_1} {want_1}");
            assert!((by_2 - want_2).norm() < 1e-7 * size, "{r1} {r2}: {by_2} {want_2}");
        }
        // In the middle of a long one: 2/rho outside of the core, linear to zero in it.
        for rho in [1e-5, 4e-4, 9e-4, 1.1e-3, 0.01] {
            let (r1, r2) = (Vector3::new(0.0, 100.0, rho), Vector3::new(0.0, -100.0, rho));
            let (velocity, _) = segment_of(&r1, &r2, &weights, core);
            let want = 2.0 / rho * (rho / core).powi(2).min(1.0);
            assert!((velocity - Vector3::x() * want).norm() < 1e-5 * want, "{rho}: {velocity} {want}");
        }
    }

    /// A leg along +x: x cross r over |r| (|r| - x) anywhere, 2/rho far downstream, with a core that turns as
    /// a solid body.
    #[test]
    fn a_leg_has_its_velocity_and_the_derivative_by_its_place() {
        let (core, weights) = (1e-3, Vector3::new(0.3, -0.7, 0.5));
        for x in [-3.0, -0.4, 0.0, 0.7, 2.5] {
            for (y, z) in [(0.4, 0.2), (-0.3, 0.8), (0.2, -0.5), (-1.5, -0.1)] {
                let r = Vector3::new(x, y, z);
                let (velocity, by) = leg_of(&r, &weights, core);
                let want = Vector3::x().cross(&r) / (r.norm() * (r.norm() - x));
                assert!((velocity - want).norm() < 1e-12 * want.norm(), "{r}: {velocity} {want}");
                let want = differences(|r| weights.dot(&leg_of(r, &weights, core).0), &r);
                assert!((by - want).norm() < 1e-7 * (1.0 + want.norm()), "{r}: {by} {want}");
            }
        }
        // Upstream on its own line nothing comes of it, but the line may move.
        let (velocity, by) = leg_of(&Vector3::new(-2.0, 0.0, 0.0), &weights, core);
        assert_eq!(velocity, Vector3::zeros());
        assert!((by - Vector3::new(0.0, weights.z, -weights.y) / 8.0).norm() < 1e-14, "{by}");
        for rho in [1e-5, 4e-4, 9e-4, 1.1e-3, 0.01] {
            let (velocity, _) = leg_of(&Vector3::new(100.0, rho, 0.0), &weights, core);
            let want = 2.0 / rho * (rho / core).powi(2).min(1.0);
            assert!((velocity - Vector3::z() * want).norm() < 1e-6 * want, "{rho}: {velocity} {want}");
        }
    }
}
