//! How the incidences that moved boxes need for given pressures change as the boxes move, each as a rigid body.
//!
//! ```text
//! E_i = sum_j A_ij cp_j,   dE_i = sum_b (dE_i/dt_b . t_b + dE_i/ds_b . s_b)
//! ```
//! t_b is the displacement of the midpoint of box b, s_b its spin. Vortices run from corner to corner, each moved by the mean of the
//! boxes that meet there ([`Seams`]); the point and the normal of a box move with that box, and so does the chord that its
//! circulation is counted by. The derivatives of [`crate::influence_of_moved`] are taken term by term; within the
//! cores of vortices, where no box of one surface is, that of the core's size is left out.

use crate::error::AeroError;
use crate::geometry::AeroBox;
use crate::horseshoe::{Horseshoe, core, horseshoes_on_surfaces, stretched};
use crate::lattice::Lattice;
use crate::mirror::MirrorPlane;
use crate::seams::Seams;
use crate::vlm::{beta, check};
use faer::Mat;
use nalgebra::Vector3;
use rayon::prelude::*;
use std::f64::consts::PI;

/// A vortex with its pressure: ends of its legs on the surface, of its bound segment, and what they move with.
struct Source {
    /// Leg's end, bound segment's two ends, leg's end, x stretched.
    points: [Vector3<f64>; 4],
    /// The places of corners that these are shares of.
    shares: [[(usize, f64); 2]; 4],
    /// The box whose pressure it has.
    of: usize,
    core: f64,
    /// Circulation over -4 pi.
    strength: f64,
    /// By the spin of its box, over its own value.
    by_spin: Vector3<f64>,
}

/// The derivatives of A cp (rad) by displacements (1/m) and spins (1/rad) of all boxes about their midpoints: six rows a box, a
/// column for each incidence.
///
/// # Errors
/// As [`crate::influence_of_moved`].
///
/// # Panics
/// If there is not one pressure coefficient a box.
pub fn influence_by_motion(
    lattice: &Lattice,
    seams: &Seams,
    plane: MirrorPlane,
    mach: f64,
    cp: &[f64],
) -> Result<Mat<f64>, AeroError> {
    check(lattice, mach)?;
    assert_eq!(cp.len(), lattice.len(), "pressures are for another number of boxes");
    let beta = beta(mach);
    let on = On { sources: sources(lattice, seams, beta, cp), lattice, seams, beta };
    let image = plane.image().map(|(y_m, sign)| Side { sign, mirror_m: Some(y_m) });
    let sides: Vec<Side> = [Side { sign: 1.0, mirror_m: None }].into_iter().chain(image).collect();
    let mut all = Mat::zeros(6 * lattice.len(), lattice.len());
    all.par_col_iter_mut().enumerate().for_each(|(at, column)| {
        // A column of a new matrix is contiguous.
        let Some(column) = column.try_as_col_major_mut() else { return };
        let out = column.as_slice_mut();
        let mut by_place = vec![Vector3::zeros(); seams.places.len()];
        for side in &sides {
            on.add_received(at, side, &mut by_place, out);
        }
        on.to_boxes(&by_place, out);
    });
    Ok(all)
}

fn sources(lattice: &Lattice, seams: &Seams, beta: f64, cp: &[f64]) -> Vec<Source> {
    let vortices = horseshoes_on_surfaces(lattice, &seams.closed(lattice), beta);
    let mut last: Vec<usize> = (0..lattice.len()).collect();
    for surface in &lattice.surfaces {
        for at in 0..surface.spanwise * surface.chordwise {
            last[surface.first_box + at] =
                surface.first_box + at - at % surface.chordwise + surface.chordwise - 1;
        }
    }
    let one = |(j, vortex): (usize, &Horseshoe)| {
        let chord = mean_chord(&lattice.boxes[j]);
        let [lead_1, trail_1, trail_2, lead_2] = seams.corners[j];
        let quarter = |lead: usize, trail: usize| [(lead, 0.75), (trail, 0.25)];
        let mut shares = [quarter(lead_1, trail_1); 4];
        (shares[2], shares[3]) = (quarter(lead_2, trail_2), quarter(lead_2, trail_2));
        if vortex.edges.is_some() {
            let [_, edge_1, edge_2, _] = seams.corners[last[j]];
            (shares[0], shares[3]) = ([(edge_1, 1.0), (edge_1, 0.0)], [(edge_2, 1.0), (edge_2, 0.0)]);
        }
        let [edge_1, edge_2] =
            vortex.edges.map_or([vortex.from, vortex.to], |edges| edges.map(|(corner, _)| corner));
        Source {
            points: [edge_1, vortex.from, vortex.to, edge_2],
            shares,
            of: j,
            core: vortex.core,
            strength: -cp[j] * vortex.circulation / (4.0 * PI),
            by_spin: chord.cross(&Vector3::x()) / chord.x,
        }
    };
    vortices.iter().enumerate().map(one).collect()
}

fn mean_chord(panel: &AeroBox) -> Vector3<f64> {
    let [c1, c2, c3, c4] = &panel.corners;
    ((c2 - c1) + (c3 - c4)) / 2.0
}

/// The vortices, or their images about a plane y = `mirror_m`, with the sign of their circulation.
struct Side {
    sign: f64,
    mirror_m: Option<f64>,
}

/// All vortices and what they are on.
struct On<'a> {
    sources: Vec<Source>,
    lattice: &'a Lattice,
    seams: &'a Seams,
    beta: f64,
}

impl On<'_> {
    /// What one box receives of one side: by the places of corners, and by its own motion and the others' chords.
    fn add_received(&self, at: usize, side: &Side, by_place: &mut [Vector3<f64>], out: &mut [f64]) {
        let (panel, sign, beta) = (&self.lattice.boxes[at], side.sign, self.beta);
        let (place, normal, own_core) = (panel.three_quarter_point(), panel.normal(), core(panel));
        let (mut point, mut along) = (stretched(&place, beta), normal * sign);
        if let Some(y_m) = side.mirror_m {
            point.y = 2.0 * y_m - point.y;
            along.y = -along.y;
        }
        let (mut by_point, mut by_normal): (Vector3<f64>, Vector3<f64>) =
            (Vector3::zeros(), Vector3::zeros());
        for source in &self.sources {
            let weights = along * source.strength;
            let (velocity, by_ends) = source.velocity(&point, &weights, own_core.min(source.core));
            by_normal += velocity * (sign * source.strength);
            for (by_end, shares) in by_ends.iter().zip(&source.shares) {
                by_point -= by_end;
                for (place, share) in shares {
                    by_place[*place] += Vector3::new(by_end.x / beta, by_end.y, by_end.z) * *share;
                }
            }
            let turned = source.by_spin * weights.dot(&velocity);
            (0..3).for_each(|i| out[6 * source.of + 3 + i] += turned[i]);
        }
        by_point.x /= beta;
        if side.mirror_m.is_some() {
            by_point.y = -by_point.y;
            by_normal.y = -by_normal.y;
        }
        add(out, at, &by_point, &(place - panel.mid_point()));
        let turned = normal.cross(&by_normal);
        (0..3).for_each(|i| out[6 * at + 3 + i] += turned[i]);
    }

    /// From the places of corners to the boxes whose mean they are.
    fn to_boxes(&self, by_place: &[Vector3<f64>], out: &mut [f64]) {
        for (meeting, by) in self.seams.places.iter().zip(by_place) {
            let across = if meeting.plane_y_m.is_some() { 0.0 } else { by.y };
            let share = Vector3::new(by.x, across, by.z) / meeting.corners.len() as f64;
            for (j, corner) in &meeting.corners {
                let panel = &self.lattice.boxes[*j];
                add(out, *j, &share, &(panel.corners[*corner] - panel.mid_point()));
            }
        }
    }
}

/// The derivative by a point that moves with a box, at an arm from its midpoint.
fn add(out: &mut [f64], at: usize, by_point: &Vector3<f64>, arm: &Vector3<f64>) {
    let by_spin = arm.cross(by_point);
    for i in 0..3 {
        out[6 * at + i] += by_point[i];
        out[6 * at + 3 + i] += by_spin[i];
    }
}

impl Source {
    /// 4 pi times the velocity of unit circulation at a point, and the derivatives of its weighted sum by the four ends.
    fn velocity(
        &self,
        point: &Vector3<f64>,
        weights: &Vector3<f64>,
        core: f64,
    ) -> (Vector3<f64>, [Vector3<f64>; 4]) {
        let r = self.points.map(|end| point - end);
        let (mut sum, mut by_ends) = (Vector3::zeros(), [Vector3::zeros(); 4]);
        // Circulation comes in along side 1, runs along the bound segment, and leaves along side 2.
        for first in 0..3 {
            if self.points[first] == self.points[first + 1] {
                continue;
            }
            let (velocity, by) = segment(&r[first], &r[first + 1], weights, core);
            sum += velocity;
            by_ends[first] -= by[0];
            by_ends[first + 1] -= by[1];
        }
        for (end, sign) in [(0, -1.0), (3, 1.0)] {
            let (velocity, by) = leg(&r[end], weights, core);
            sum += velocity * sign;
            by_ends[end] -= by * sign;
        }
        (sum, by_ends)
    }
}

/// A segment seen from its ends: velocity, and the derivatives of its weighted sum by both vectors.
fn segment(
    r1: &Vector3<f64>,
    r2: &Vector3<f64>,
    weights: &Vector3<f64>,
    core: f64,
) -> (Vector3<f64>, [Vector3<f64>; 2]) {
    let (l1, l2) = (r1.norm().max(core), r2.norm().max(core));
    let (cross, product, dot) = (r1.cross(r2), l1 * l2, r1.dot(r2));
    let least = core * core * (r1 - r2).norm_squared();
    let sum = if dot < 0.0 { cross.norm_squared().max(least) / (product - dot) } else { product + dot };
    let size = (l1 + l2) / (product * sum);
    let weighted = weights.dot(&cross) * size;
    let unit = |r: &Vector3<f64>, l: f64| if l > core { r / l } else { Vector3::zeros() };
    let by_size = |u: Vector3<f64>, l_other: f64, other: &Vector3<f64>| {
        u / (l1 + l2) - u * (l_other / product) - (u * l_other + other) / sum
    };
    let by_1 = r2.cross(weights) * size + by_size(unit(r1, l1), l2, r2) * weighted;
    let by_2 = weights.cross(r1) * size + by_size(unit(r2, l2), l1, r1) * weighted;
    (cross * size, [by_1, by_2])
}

/// A leg along +x seen from its end: velocity, and the derivative of its weighted sum.
fn leg(r: &Vector3<f64>, weights: &Vector3<f64>, core: f64) -> (Vector3<f64>, Vector3<f64>) {
    let l = r.norm().max(core);
    let rho_2 = (r.y * r.y + r.z * r.z).max(core * core);
    let size = if r.x > 0.0 { (l + r.x) / (rho_2 * l) } else { 1.0 / ((l - r.x) * l) };
    let turned = Vector3::new(0.0, -r.z, r.y);
    let weighted = weights.dot(&turned);
    let by_radius = -size * size * (2.0 * l - r.x) / l;
    let by_size = Vector3::new(1.0 / (l * l * l), by_radius * r.y, by_radius * r.z);
    (turned * size, Vector3::new(0.0, weights.z, -weights.y) * size + by_size * weighted)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::vlm::influence_of_moved;
    use nalgebra::{Point3, Rotation3};

    /// A wing of 2 by 3 boxes and a tail of two behind it, each out of place.
    fn bent(plane: MirrorPlane) -> (Lattice, Seams) {
        let wing = Lattice::trapezoid(1, [0.0, 0.1, 0.0], 1.0, [0.4, 3.0, 0.0], 0.7, [2, 3]).expect("boxes");
        let tail = Lattice::trapezoid(11, [2.2, 0.1, 0.4], 0.9, [2.4, 1.6, 0.5], 0.7, [2, 1]).expect("boxes");
        let mut lattice = wing.joined(&tail).expect("one lattice");
        let seams = Seams::of(&lattice, plane);
        for at in 0..lattice.len() {
            let size = 0.1 * (1.0 + at as f64).sin();
            move_box(&mut lattice, at, &[0.2 * size, -0.1 * size, size, 2.0 * size, -0.9 * size, 0.4 * size]);
        }
        (lattice, seams)
    }

    fn move_box(lattice: &mut Lattice, at: usize, motion: &[f64; 6]) {
        let middle = lattice.boxes[at].mid_point();
        let spin = Rotation3::from_scaled_axis(Vector3::new(motion[3], motion[4], motion[5]));
        let shift = Vector3::new(motion[0], motion[1], motion[2]);
        let moved = |corner: Point3<f64>| middle + shift + spin * (corner - middle);
        lattice.boxes[at].corners = lattice.boxes[at].corners.map(moved);
    }

    #[test]
    fn derivatives_by_motions_of_boxes_are_those_of_differences() {
        for (plane, mach) in [
            (MirrorPlane::None, 0.0),
            (MirrorPlane::Symmetric { y_m: -0.05 }, 0.4),
            (MirrorPlane::Symmetric { y_m: 0.1 }, 0.0),
            (MirrorPlane::Antisymmetric { y_m: -0.05 }, 0.0),
        ] {
            let (lattice, seams) = bent(plane);
            let cp: Vec<f64> = (0..lattice.len()).map(|j| 1.0 + 0.4 * (j as f64).cos()).collect();
            let needed = |lattice: &Lattice| -> Vec<f64> {
                let a = influence_of_moved(lattice, &seams, plane, mach).expect("boxes");
                (0..cp.len()).map(|i| (0..cp.len()).map(|j| a[(i, j)] * cp[j]).sum()).collect()
            };
            let found = influence_by_motion(&lattice, &seams, plane, mach, &cp).expect("boxes");
            for motion in 0..6 * lattice.len() {
                let step = 1e-5;
                let [up, down] = [step, -step].map(|step| {
                    let mut moved = lattice.clone();
                    let mut motions = [0.0; 6];
                    motions[motion % 6] = step;
                    move_box(&mut moved, motion / 6, &motions);
                    needed(&moved)
                });
                for i in 0..cp.len() {
                    let difference = (up[i] - down[i]) / (2.0 * step);
                    let own = found[(motion, i)];
                    assert!(
                        (own - difference).abs() < 2e-8 * (1.0 + difference.abs()),
                        "{plane:?}: incidence {i} by motion {motion}: {own}, by differences {difference}"
                    );
                }
            }
        }
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
            let (velocity, [by_1, by_2]) = segment(&r1, &r2, &weights, core);
            let (l1, l2) = (r1.norm().max(core), r2.norm().max(core));
            let want = r1.cross(&r2) * ((1.0 / l1 + 1.0 / l2) / (l1 * l2 + r1.dot(&r2)));
            assert!((velocity - want).norm() < 1e-12 * (1.0 + want.norm()), "{velocity} {want}");
            let of = |a: &Vector3<f64>, b: &Vector3<f64>| weights.dot(&segment(a, b, &weights, core).0);
            let (want_1, want_2) = (differences(|r| of(r, &r2), &r1), differences(|r| of(&r1, r), &r2));
            let size = 1.0 + want_1.norm() + want_2.norm();
            assert!((by_1 - want_1).norm() < 1e-7 * size, "{r1} {r2}: {by_1} {want_1}");
            assert!((by_2 - want_2).norm() < 1e-7 * size, "{r1} {r2}: {by_2} {want_2}");
        }
        // In the middle of a long one: 2/rho outside of the core, linear to zero in it.
        for rho in [1e-5, 4e-4, 9e-4, 1.1e-3, 0.01] {
            let (r1, r2) = (Vector3::new(0.0, 100.0, rho), Vector3::new(0.0, -100.0, rho));
            let (velocity, _) = segment(&r1, &r2, &weights, core);
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
                let (velocity, by) = leg(&r, &weights, core);
                let want = Vector3::x().cross(&r) / (r.norm() * (r.norm() - x));
                assert!((velocity - want).norm() < 1e-12 * want.norm(), "{r}: {velocity} {want}");
                let want = differences(|r| weights.dot(&leg(r, &weights, core).0), &r);
                assert!((by - want).norm() < 1e-7 * (1.0 + want.norm()), "{r}: {by} {want}");
            }
        }
        // Upstream on its own line nothing comes of it, but the line may move.
        let (velocity, by) = leg(&Vector3::new(-2.0, 0.0, 0.0), &weights, core);
        assert_eq!(velocity, Vector3::zeros());
        assert!((by - Vector3::new(0.0, weights.z, -weights.y) / 8.0).norm() < 1e-14, "{by}");
        for rho in [1e-5, 4e-4, 9e-4, 1.1e-3, 0.01] {
            let (velocity, _) = leg(&Vector3::new(100.0, rho, 0.0), &weights, core);
            let want = 2.0 / rho * (rho / core).powi(2).min(1.0);
            assert!((velocity - Vector3::z() * want).norm() < 1e-6 * want, "{rho}: {velocity} {want}");
        }
    }
}
