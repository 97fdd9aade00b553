//! How the incidences that moved boxes need for given pressures change as the boxes move, each as a rigid body.
//!
//! ```text
//! E_i = sum_j A_ij cp_j,   dE_i = sum_b (dE_i/dt_b . t_b + dE_i/ds_b . s_b)
//! ```
//! t_b is the displacement of the midpoint of box b, s_b its spin. Vortices run from corner to corner, each moved by the mean of the
//! boxes that meet there ([`Seams`]); the point and the normal of a box move with that box, and so does the chord that its
//! circulation is counted by. The derivatives of [`crate::influence_of_moved`] are taken term by term; within the
//! cores of vortices, where no box of one surface is, that of the core's size is left out.

mod by_ends;

use crate::error::AeroError;
use crate::geometry::AeroBox;
use crate::horseshoe::{Horseshoe, core, horseshoes_on_surfaces, stretched};
use crate::lattice::Lattice;
use crate::mirror::MirrorPlane;
use crate::seams::Seams;
use crate::vlm::{beta, check};
use by_ends::{BLOCK, Block, ENDS, Receiver, Seen};
use faer::Mat;
use nalgebra::Vector3;
use rayon::prelude::*;

/// What a vortex moves with.
struct Hung {
    /// The places of corners that its ends are shares of.
    shares: [[(usize, f64); 2]; ENDS],
    /// Change of its circulation by the spin of its box, over its own value.
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
    let on = On::new(lattice, seams, beta, cp);
    let image = plane.image().map(|(y_m, sign)| Side { sign, mirror_m: Some(y_m) });
    let sides: Vec<Side> = [Side { sign: 1.0, mirror_m: None }].into_iter().chain(image).collect();
    let mut all = Mat::zeros(6 * lattice.len(), lattice.len());
    all.par_col_iter_mut().enumerate().for_each(|(at, column)| {
        // A column of a new matrix is contiguous.
        let Some(column) = column.try_as_col_major_mut() else { return };
        let out = column.as_slice_mut();
        let mut by_place = vec![Vector3::zeros(); seams.places.len()];
        on.add_received(at, &sides, &mut by_place, out);
        on.to_boxes(&by_place, out);
    });
    Ok(all)
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

impl Side {
    /// A box's point and normal as the vortices of this side see them.
    fn receiver(&self, panel: &AeroBox, beta: f64) -> Receiver {
        let (mut point, mut along) =
            (stretched(&panel.three_quarter_point(), beta), panel.normal() * self.sign);
        if let Some(y_m) = self.mirror_m {
            point.y = 2.0 * y_m - point.y;
            along.y = -along.y;
        }
        Receiver::new(point.into(), along.into(), core(panel))
    }
}

/// All vortices and what they are on.
struct On<'a> {
    blocks: Vec<Block>,
    /// One a vortex.
    hung: Vec<Hung>,
    lattice: &'a Lattice,
    seams: &'a Seams,
    beta: f64,
}

impl<'a> On<'a> {
    fn new(lattice: &'a Lattice, seams: &'a Seams, beta: f64, cp: &[f64]) -> Self {
        let vortices = horseshoes_on_surfaces(lattice, &seams.closed(lattice), beta);
        let mut last: Vec<usize> = (0..lattice.len()).collect();
        for surface in &lattice.surfaces {
            for at in 0..surface.spanwise * surface.chordwise {
                last[surface.first_box + at] =
                    surface.first_box + at - at % surface.chordwise + surface.chordwise - 1;
            }
        }
        let hung = |(j, vortex): (usize, &Horseshoe)| {
            let chord = mean_chord(&lattice.boxes[j]);
            let [lead_1, trail_1, trail_2, lead_2] = seams.corners[j];
            let quarter = |lead: usize, trail: usize| [(lead, 0.75), (trail, 0.25)];
            let mut shares = [quarter(lead_1, trail_1); ENDS];
            (shares[2], shares[3]) = (quarter(lead_2, trail_2), quarter(lead_2, trail_2));
            if vortex.edges.is_some() {
                let [_, edge_1, edge_2, _] = seams.corners[last[j]];
                (shares[0], shares[3]) = ([(edge_1, 1.0), (edge_1, 0.0)], [(edge_2, 1.0), (edge_2, 0.0)]);
            }
            Hung { shares, by_spin: chord.cross(&Vector3::x()) / chord.x }
        };
        let blocks = vortices.chunks(BLOCK).zip(cp.chunks(BLOCK));
        Self {
            blocks: blocks.map(|(vortices, cp)| Block::new(vortices, cp)).collect(),
            hung: vortices.iter().enumerate().map(hung).collect(),
            lattice,
            seams,
            beta,
        }
    }

    /// What one box receives: by the places of corners, and by its own motion and the others' chords.
    fn add_received(&self, at: usize, sides: &[Side], by_place: &mut [Vector3<f64>], out: &mut [f64]) {
        let panel = &self.lattice.boxes[at];
        let mut receivers: Vec<Receiver> = sides.iter().map(|side| side.receiver(panel, self.beta)).collect();
        for (first, (block, hung)) in self.blocks.iter().zip(self.hung.chunks(BLOCK)).enumerate() {
            let mut seen = Seen::nothing();
            for receiver in &mut receivers {
                block.add_to(receiver, &mut seen);
            }
            for (l, hung) in hung.iter().enumerate() {
                for (by_end, shares) in seen.by_end.iter().zip(&hung.shares) {
                    let by_end = Vector3::new(by_end[0][l] / self.beta, by_end[1][l], by_end[2][l]);
                    for (place, share) in shares {
                        by_place[*place] += by_end * *share;
                    }
                }
                let turned = hung.by_spin * seen.incidence[l];
                (0..3).for_each(|i| out[6 * (first * BLOCK + l) + 3 + i] += turned[i]);
            }
        }
        for (side, receiver) in sides.iter().zip(&receivers) {
            let across = if side.mirror_m.is_some() { -1.0 } else { 1.0 };
            let [x, y, z] = receiver.by_point();
            let by_point = Vector3::new(x / self.beta, across * y, z);
            add(out, at, &by_point, &(panel.three_quarter_point() - panel.mid_point()));
            let [x, y, z] = receiver.velocity();
            let turned = panel.normal().cross(&(Vector3::new(x, across * y, z) * side.sign));
            (0..3).for_each(|i| out[6 * at + 3 + i] += turned[i]);
        }
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
}
