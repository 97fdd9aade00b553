//! Small motions about an equilibrium of the bent wing: tangent modes, what the boxes do in them, and what the steady loads do.
//!
//! In coordinates x of the tangent modes (unit generalised mass) about a state with pressures cp
//! ```text
//! x'' + diag(omega^2) x = A_0 x + q R cp_x,     cp_x from w = W_x x - i (omega/V) H x
//! ```
//! A_0: the loads of the steady pressures turn and move with the boxes (their directions and arms). W_x: change of the
//! stream along the box's normal. H: displacement of its three-quarter point along it. R: work of a unit pressure coefficient. Columns are differences of
//! the places of boxes, exact to their round-off. Left out is what in-plane motions do with steady loads (lagging and
//! yawing strips).

use super::air::{Loaded, Solved};
use super::wing::{LargeState, LargeWing};
use crate::case::SteadyCase;
use crate::error::CouplingError;
use aero::{AeroBox, Corrections, Lattice};
use faer::Mat;
use nalgebra::{Point3, Vector3};
use structure::nonlinear::{Loads, Near, NodeLoad, State};
use structure::{Modes, ModesError, normal_modes};

/// Largest displacement or spin (m, rad) of a node in the differences.
const STEP: f64 = 1e-5;

/// The wing as it answers small motions about an equilibrium.
#[derive(Debug, Clone)]
pub struct BentMotion {
    /// Natural frequencies of the loaded wing without the air's answer, rad/s.
    pub omega_rad_s: Vec<f64>,
    /// Displacements and spins of all nodes (g-set, basic axes) by mode; unit generalised mass.
    pub shapes: Mat<f64>,
    /// The boxes for doublets: x along the stream, sides of strips along it.
    pub lattice: Lattice,
    /// W_x: incidence of boxes by mode, rad.
    pub incidence: Mat<f64>,
    /// H: displacement of three-quarter points along the normals by mode, m.
    pub heave: Mat<f64>,
    /// R: modes by boxes: work of a unit pressure coefficient, corrections included, m^2 per unit dynamic pressure.
    pub work: Mat<f64>,
    /// A_0: work of the steady loads that turn and move, modes by modes, 1/s^2.
    pub load_stiffness: Mat<f64>,
}

/// Why there is no such motion.
#[derive(Debug, thiserror::Error)]
pub enum BentMotionError {
    /// The steady state.
    #[error(transparent)]
    Coupling(#[from] CouplingError),
    /// Its modes.
    #[error("modes of the bent wing: {0}")]
    Modes(#[from] ModesError),
}

impl LargeWing {
    /// Natural modes of the bent wing under its loads of now, without the air's answer to them.
    ///
    /// # Errors
    /// If there are not so many, or they cannot be found.
    pub fn tangent_modes(&self, state: &LargeState, count: usize) -> Result<(Modes, Mat<f64>), ModesError> {
        let three = |six: &[f64], first: usize| Vector3::new(six[first], six[first + 1], six[first + 2]);
        let node =
            |(node, six): (usize, &[f64])| NodeLoad { node, force: three(six, 0), moment: three(six, 3) };
        let dead = state.forces.chunks_exact(6).enumerate().map(node).collect();
        let system = self.structure.tangent_system(&state.state, &Loads { dead, ..Loads::default() });
        let modes = normal_modes(&system, count)?;
        let shapes = system.expand(modes.shapes.as_ref());
        Ok((modes, shapes))
    }

    /// Small motions about an equilibrium of a case with corrections (one entry for each correctable box) in its lowest modes.
    ///
    /// # Errors
    /// If modes are not found, or the corrections have the wrong length.
    pub fn small_motion(
        &self,
        case: &SteadyCase,
        corrections: &Corrections,
        state: &LargeState,
        count: usize,
    ) -> Result<BentMotion, BentMotionError> {
        let (modes, shapes) = self.tangent_modes(state, count)?;
        let air = self.air(case, corrections)?;
        let stuck = CouplingError::from(nastran::InputError::general(
            "the lattice of the bent wing cannot be solved",
        ));
        let solved = air.solved(&state.state).ok_or(stuck)?;
        let boxes = self.elastic.lattice.len();
        let mut motion = BentMotion {
            lattice: along_the_stream(&solved.surface()),
            incidence: Mat::zeros(boxes, count),
            heave: Mat::zeros(boxes, count),
            work: Mat::zeros(count, boxes),
            load_stiffness: Mat::zeros(count, count),
            omega_rad_s: modes.omega_rad_s.clone(),
            shapes,
        };
        let loaded = solved.loaded(&state.state);
        for mode in 0..count {
            let shape: Vec<f64> = motion.shapes.col(mode).iter().copied().collect();
            let size = shape.iter().fold(f64::MIN_POSITIVE, |most, v| v.abs().max(most));
            let step = STEP / size;
            let sides = [step, -step].map(|step| {
                let moved: Vec<f64> = shape.iter().map(|v| v * step).collect();
                state.state.moved_by(&moved)
            });
            motion.add_column(mode, &solved, &loaded, &sides, step);
        }
        Ok(motion)
    }
}

impl LargeWing {
    /// Work of the steady air (1/s^2) in the modes of a motion about an equilibrium by unit coordinates, with the influence of the
    /// lattice as it stands: modes by modes. What doublets at rest and steady loads that turn are the sum of.
    ///
    /// # Errors
    /// If the corrections have the wrong length.
    pub fn following_work(
        &self,
        case: &SteadyCase,
        corrections: &Corrections,
        state: &LargeState,
        motion: &BentMotion,
    ) -> Result<Mat<f64>, CouplingError> {
        let count = motion.omega_rad_s.len();
        let air = self.air(case, corrections)?;
        let mut all = Mat::zeros(count, count);
        let Some(solved) = air.solved(&state.state) else { return Ok(all) };
        for mode in 0..count {
            let shape: Vec<f64> = motion.shapes.col(mode).iter().copied().collect();
            let step = STEP / shape.iter().fold(f64::MIN_POSITIVE, |most, v| v.abs().max(most));
            let forces = [step, -step].map(|step| {
                let moved: Vec<f64> = shape.iter().map(|v| v * step).collect();
                solved.following(&state.state.moved_by(&moved))
            });
            for other in 0..count {
                let change = forces[0].iter().zip(&forces[1]).enumerate();
                all[(other, mode)] =
                    change.map(|(dof, (up, down))| (up - down) * motion.shapes[(dof, other)]).sum::<f64>()
                        / (2.0 * step);
            }
        }
        Ok(all)
    }
}

impl BentMotion {
    /// The columns of one mode from the states on both sides.
    fn add_column(
        &mut self,
        mode: usize,
        solved: &Solved<'_>,
        loaded: &Loaded,
        sides: &[State; 2],
        step: f64,
    ) {
        let boxes = sides.each_ref().map(|side| solved.turned_boxes(side));
        let w = boxes.each_ref().map(|lattice| solved.incidence(lattice));
        let rise = |j: usize, of: &dyn Fn(&AeroBox) -> Point3<f64>| {
            (of(&boxes[0].boxes[j]) - of(&boxes[1].boxes[j])) / (2.0 * step)
        };
        let now = solved.turned_boxes(solved.state());
        let unit = solved.unit_loads(&now);
        for (j, [force, moment]) in unit.iter().enumerate() {
            self.incidence[(j, mode)] = (w[0][j] - w[1][j]) / (2.0 * step);
            self.heave[(j, mode)] = rise(j, &AeroBox::three_quarter_point).dot(&now.boxes[j].normal());
            let axes = boxes.each_ref().map(|lattice| frame(&lattice.boxes[j]));
            let turn = axes[0] * axes[1].transpose();
            let spin = Vector3::new(
                turn[(2, 1)] - turn[(1, 2)],
                turn[(0, 2)] - turn[(2, 0)],
                turn[(1, 0)] - turn[(0, 1)],
            ) / (4.0 * step);
            self.work[(mode, j)] = force.dot(&rise(j, &AeroBox::mid_point)) + moment.dot(&spin);
        }
        let forces = sides.each_ref().map(|side| solved.same_loads_on_nodes(loaded, side));
        for other in 0..self.omega_rad_s.len() {
            let work = |forces: &[f64]| -> f64 {
                forces.iter().enumerate().map(|(dof, force)| force * self.shapes[(dof, other)]).sum()
            };
            self.load_stiffness[(other, mode)] = (work(&forces[0]) - work(&forces[1])) / (2.0 * step);
        }
    }
}

/// Axes of a box: normal, span, and their cross product.
fn frame(panel: &AeroBox) -> nalgebra::Matrix3<f64> {
    let normal = panel.normal();
    let [c1, _, _, c4] = &panel.corners;
    let along = (c4 - c1) - normal * normal.dot(&(c4 - c1));
    let span = along.normalize();
    nalgebra::Matrix3::from_columns(&[normal, span, normal.cross(&span)])
}

/// Boxes as doublets need them: the sides of a strip lie along the stream, at y and z of its middle there. Their dihedral and places
/// stay, their incidence is in the steady part.
fn along_the_stream(lattice: &Lattice) -> Lattice {
    let mut along = lattice.clone();
    for surface in &lattice.surfaces {
        for strip in 0..surface.spanwise {
            let first = surface.first_box + strip * surface.chordwise;
            let last = first + surface.chordwise - 1;
            let [lead_1, _, _, lead_2] = &lattice.boxes[first].corners;
            let [_, trail_1, trail_2, _] = &lattice.boxes[last].corners;
            let sides = [nalgebra::center(lead_1, trail_1), nalgebra::center(lead_2, trail_2)];
            for panel in &mut along.boxes[first..=last] {
                for (corner, side) in panel.corners.iter_mut().zip([0, 0, 1, 1]) {
                    (corner.y, corner.z) = (sides[side].y, sides[side].z);
                }
            }
        }
    }
    along
}
