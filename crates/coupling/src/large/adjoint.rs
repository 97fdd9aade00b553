//! Derivatives of what is measured on the bent wing by the corrections, exact.
//!
//! ```text
//! (K - A)^T lambda = dJ/du,   dJ/dP = (dJ/dP at rest) + lambda on the boxes
//! ```
//! A is the whole change of the loads by the motion of the nodes: pressures by incidences and by the moved lattice, directions and
//! places of forces. Box loads are linear in the corrections, so that [`aero::LoadOperator::derivatives`] says the rest, as of the
//! linear wing.

use super::air::{Loaded, Solved, directions};
use super::answer::{Answer, OnBoxes};
use super::wing::{LargeState, LargeWing};
use crate::case::{RootSensitivity, SteadyCase};
use crate::error::CouplingError;
use aero::Corrections;
use faer::Mat;
use nalgebra::{Point3, Vector3};
use nastran::InputError;
use structure::nonlinear::{DeadChange, State, differenced, moments_across};

/// Fz, Mx, My; the tip's height follows them.
const LOADS: usize = 3;

/// All about one state.
struct About<'a> {
    wing: &'a LargeWing,
    solved: &'a Solved<'a>,
    loaded: &'a Loaded,
    answer: Answer<'a>,
    dead: DeadChange,
    weight: &'a [f64],
}

impl LargeWing {
    /// Readings of an equilibrium of a case with corrections (one entry for each correctable box), and their derivatives by the
    /// corrections.
    ///
    /// # Errors
    /// If the state is no equilibrium, or the corrections have the wrong length.
    pub fn sensitivity(
        &self,
        case: &SteadyCase,
        corrections: &Corrections,
        state: &LargeState,
    ) -> Result<RootSensitivity, CouplingError> {
        let air = self.air(case, corrections)?;
        let places = &self.elastic.correctable.places;
        let mut rows = Mat::zeros(LOADS + 1, 2 * self.elastic.lattice.len());
        if air.q_pa > 0.0 {
            let stuck = || InputError::general("the bent wing cannot be solved again at its equilibrium");
            let solved = air.solved(&state.state).ok_or_else(stuck)?;
            let loaded = solved.loaded(&state.state);
            let weight = self.structure.load_forces(&state.state, &air.weight());
            let about = About {
                wing: self,
                answer: Answer::new(&solved, &loaded)?,
                dead: self.structure.change_of_dead(&state.state, &air.weight()),
                solved: &solved,
                loaded: &loaded,
                weight: &weight,
            };
            rows = about.rows(&state.forces).ok_or_else(stuck)?;
        }
        let by = self.elastic.integration.corrected(&air.corrections).derivatives(
            air.q_pa,
            rows.as_ref(),
            &state.cp,
            places,
        );
        Ok(RootSensitivity {
            loads: state.root,
            tip_z_m: state.tip_m.z,
            by_force: by.by_force,
            by_moment: by.by_moment,
            by_offset: by.by_offset,
        })
    }
}

impl About<'_> {
    /// Readings per unit lift and moment of each box (two columns a box), the wing's answer included.
    fn rows(&self, forces: &[f64]) -> Option<Mat<f64>> {
        let state = self.solved.state();
        let held: Vec<OnBoxes> = (0..LOADS).map(|reading| self.on_boxes(reading)).collect();
        let mut readings: Vec<Vec<f64>> =
            (0..LOADS).map(|reading| self.by_motion(reading, &held[reading])).collect();
        let mut tip = vec![0.0; forces.len()];
        tip[6 * self.wing.tip + 2] = 1.0;
        readings.push(tip);
        let change = |motion: &[f64]| self.transposed(motion);
        let lambda = self.wing.structure.adjoint(state, forces, &change, &readings)?;
        let boxes = self.solved.turned_boxes(state);
        let (back, stream) = (self.solved.air.to_wake().inverse(), self.solved.air.stream());
        let mut rows = Mat::zeros(LOADS + 1, 2 * boxes.len());
        for (reading, lambda) in lambda.iter().enumerate() {
            let moved = self.wing.boxes.motions(&self.wing.elastic.lattice, state, lambda);
            for (j, panel) in boxes.boxes.iter().enumerate() {
                let [force, moment] = directions(panel, &stream).map(|direction| back * direction);
                let [mut shift, mut spin] = moved[j];
                if let Some(held) = held.get(reading) {
                    shift += held[j][0];
                    spin += held[j][1];
                }
                rows[(reading, 2 * j)] = shift.dot(&force);
                rows[(reading, 2 * j + 1)] = spin.dot(&moment);
            }
        }
        Some(rows)
    }

    /// What a root load weighs forces (at a place) and moments by; nothing on boxes that the balance does not feel.
    fn weights(&self, reading: usize, place: &Point3<f64>) -> [Vector3<f64>; 2] {
        let axis = Self::axis(reading);
        if reading == 0 {
            return [axis, Vector3::zeros()];
        }
        [axis.cross(&(place - self.wing.elastic.balance.point)), axis]
    }

    fn axis(reading: usize) -> Vector3<f64> {
        [Vector3::z(), Vector3::x(), Vector3::y()][reading]
    }

    fn on_boxes(&self, reading: usize) -> OnBoxes {
        let (boxes, metric) = (&self.loaded.boxes.lattice.boxes, &self.wing.elastic.balance.metric);
        let one = |(j, panel): (usize, &aero::AeroBox)| {
            if metric[j] { self.weights(reading, &panel.mid_point()) } else { [Vector3::zeros(); 2] }
        };
        boxes.iter().enumerate().map(one).collect()
    }

    /// Derivative of a root load by displacements and spins of the nodes, box loads answering.
    fn by_motion(&self, reading: usize, weights: &OnBoxes) -> Vec<f64> {
        let is_moment = reading > 0;
        let axis = Self::axis(reading);
        let mut on_boxes = self.answer.transposed(weights);
        for (j, own) in on_boxes.iter_mut().enumerate() {
            if is_moment && self.wing.elastic.balance.metric[j] {
                own[0] += self.loaded.loads[j][0].cross(&axis);
            }
        }
        let mut all = self.wing.boxes.to_nodes(&self.loaded.boxes, &on_boxes);
        let places = &self.solved.state().places;
        let rigid: Vec<f64> = places
            .iter()
            .flat_map(|place| self.weights(reading, &Point3::from(*place)))
            .flat_map(|own| [own.x, own.y, own.z])
            .collect();
        for (all, own) in all.iter_mut().zip(self.dead.transposed(&rigid)) {
            *all += own;
        }
        for (all, weight) in all.chunks_exact_mut(6).zip(self.weight.chunks_exact(6)).filter(|_| is_moment) {
            let moved = Vector3::from_column_slice(&weight[..3]).cross(&axis);
            (0..3).for_each(|i| all[i] += moved[i]);
        }
        all
    }

    /// The change of weight and air by the motion of the nodes, for [`structure::nonlinear::LargeDeflection::adjoint`].
    fn transposed(&self, motion: &[f64]) -> Vec<f64> {
        let (wing, state) = (self.wing, self.solved.state());
        let lattice = &wing.elastic.lattice;
        let on_nodes =
            |state: &State| wing.boxes.to_nodes(&wing.boxes.moved(lattice, state), &self.loaded.loads);
        let moved = wing.boxes.motions(lattice, state, motion);
        let mut on_boxes = self.answer.transposed(&moved);
        for ((own, [_, spin]), [_, moment]) in on_boxes.iter_mut().zip(&moved).zip(&self.loaded.loads) {
            // Moments fixed in space have no potential.
            own[1] -= moment.cross(spin);
        }
        let answer = wing.boxes.to_nodes(&self.loaded.boxes, &on_boxes);
        // Loads fixed in space reach the nodes by arms that turn.
        let arms = differenced(motion, |motion| on_nodes(&state.moved_by(motion)));
        let across = moments_across(&on_nodes(state), motion);
        let weight = self.dead.transposed_in_equilibrium(motion);
        let sum = |dof: usize| answer[dof] + arms[dof] + 0.5 * across[dof] + weight[dof];
        (0..motion.len()).map(sum).collect()
    }
}
