//! What readings of an equilibrium say of the loads: one transposed solve a reading instead of one solve a load.
//!
//! (K - A)^T lambda = dJ/du: then a load that acts with the virtual work p . du changes the reading J by p . lambda. K is the tangent
//! stiffness with the ties that turn, A the change of all that acts by the motion of the nodes.
//!
//! Spins do not commute. Forces on the nodes that have a potential, with the moments m at the nodes, change by D v in a motion v with
//! w . D v - v . D w = m . (w x v): D is not symmetric, but D v + m x v/2 is. In equilibrium the moments of all that
//! acts on a free node cancel, so every part is taken in this symmetric form, elements and ties as the weight.

use super::krylov;
use super::state::State;
use super::structure::LargeDeflection;
use crate::dofs::DofMap;
use faer::Mat;
use nalgebra::Vector3;
use rayon::prelude::*;

/// Residual of the transposed equations, relative.
const RESIDUAL: f64 = 1e-9;

/// The change of what acts by motions of the nodes, seen from the other side: a virtual motion of all nodes in (m, rad; g-set, basic
/// axes), the derivative of its work by displacements and spins out (N, Nm), in the symmetric form of the module.
pub type Transposed<'a> = dyn Fn(&[f64]) -> Vec<f64> + Sync + 'a;

impl LargeDeflection {
    /// The motions lambda (m, rad a unit of the reading; g-set, basic axes) of readings with derivatives by displacements and spins of
    /// the nodes (g-set), at an equilibrium under `forces` (N, Nm; g-set). Nothing if the state is none, or cannot be solved.
    pub fn adjoint(
        &self,
        state: &State,
        forces: &[f64],
        change: &Transposed<'_>,
        readings: &[Vec<f64>],
    ) -> Option<Vec<Vec<f64>>> {
        let (map, inner) = (self.map(state), self.inner(state));
        let short: Vec<f64> = inner.forces.iter().zip(forces).map(|(i, o)| i - o).collect();
        let factor = self.factored_tangent(state, &map, &inner.placed, &inner.local, &short)?;
        let solve = |b: &[f64]| -> Vec<f64> {
            factor.solve(Mat::from_fn(b.len(), 1, |i, _| -b[i]).as_ref()).col(0).iter().copied().collect()
        };
        let supports = self.support_moments(state, &short);
        let product = |v: &[f64]| -> Vec<f64> {
            let acting = Self::reduced(&map, &change(&expanded(&map, v)));
            let means = self.turning_means(state, &map, &short, v);
            let mut all: Vec<f64> = acting.iter().zip(means).map(|(acting, means)| means - acting).collect();
            // Transposed: with the other sign, which means have as it is.
            if let Some(moments) = &supports {
                let times = if self.joints.has_means() { 2.0 } else { 1.0 };
                let own = Self::turning_supports(&map, moments, v);
                all.iter_mut().zip(own).for_each(|(all, own)| *all += times * own);
            }
            all
        };
        let one = |reading: &Vec<f64>| {
            let right: Vec<f64> = Self::reduced(&map, reading).iter().map(|v| -v).collect();
            expanded(&map, &krylov::solve(&right, &solve, product, RESIDUAL))
        };
        Some(readings.par_iter().map(one).collect())
    }

    /// What turning ties add to the product of the tangent with a motion of the free ones, beyond what the tangent has of them: all of
    /// weighted means (RBE3).
    pub(super) fn turning_means(
        &self,
        state: &State,
        map: &DofMap,
        unbalanced: &[f64],
        v: &[f64],
    ) -> Vec<f64> {
        if !self.joints.has_means() {
            return vec![0.0; v.len()];
        }
        let motion = expanded(map, v);
        let all = self.joints.change_of_carried(state, unbalanced, &motion);
        let mut taken: Vec<f64> =
            moments_across(unbalanced, &motion).iter().map(|moment| 0.5 * moment).collect();
        for (dofs, term) in self.joints.turning_arms(state, unbalanced) {
            for (i, row) in dofs.iter().enumerate() {
                taken[*row] +=
                    dofs.iter().enumerate().map(|(j, dof)| term[(i, j)] * motion[*dof]).sum::<f64>();
            }
        }
        all.iter().zip(Self::reduced(map, &taken)).map(|(all, taken)| all - taken).collect()
    }

    /// The moments m with which supports hold one of three rotations of a node, by what the nodes are `short` of equilibrium by (Nm; g-set, basic axes).
    /// Nothing if no node is half held.
    pub(super) fn support_moments(&self, state: &State, short: &[f64]) -> Option<Vec<f64>> {
        if self.half_held.is_empty() {
            return None;
        }
        let own = self.joints.reactions(state, short);
        let mut moments = vec![0.0; own.len()];
        for node in &self.half_held {
            let moment = Vector3::from_column_slice(&own[6 * node + 3..6 * node + 6]);
            let basic = self.joints.axes[*node].map_or(moment, |axes| axes * moment);
            moments[6 * node + 3..6 * node + 6].copy_from_slice(basic.as_slice());
        }
        Some(moments)
    }

    /// m x w / 2 of these moments and the spins of a motion of the free ones: as spins do not commute, the tangent is its symmetric part less
    /// this. [`Self::turning_means`] has it among all that turns.
    pub(super) fn turning_supports(map: &DofMap, moments: &[f64], v: &[f64]) -> Vec<f64> {
        let across = moments_across(moments, &expanded(map, v));
        Self::reduced(map, &across).iter().map(|moment| 0.5 * moment).collect()
    }
}

/// m x v at every node: moments of forces on the nodes (Nm; g-set) and spins of a motion.
pub fn moments_across(forces: &[f64], motion: &[f64]) -> Vec<f64> {
    let spin = |six: &[f64]| Vector3::new(six[3], six[4], six[5]);
    let across = |(forces, motion): (&[f64], &[f64])| {
        let moment = spin(forces).cross(&spin(motion));
        [0.0, 0.0, 0.0, moment.x, moment.y, moment.z]
    };
    forces.chunks_exact(6).zip(motion.chunks_exact(6)).flat_map(across).collect()
}

/// The motion of all nodes by that of the free ones.
fn expanded(map: &DofMap, v: &[f64]) -> Vec<f64> {
    map.rows.iter().map(|row| row.iter().map(|(at, factor)| factor * v[*at]).sum()).collect()
}
