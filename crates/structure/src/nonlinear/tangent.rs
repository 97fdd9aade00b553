//! The structure as it answers small motions about a state: tangent stiffness and turned masses, for modes about a bent wing.

use super::loads::Loads;
use super::state::State;
use super::structure::LargeDeflection;
use crate::assemble::{Free, free_motions};
use crate::sparse::Pattern;
use crate::system::System;
use nalgebra::{DMatrix, Point3};

impl LargeDeflection {
    /// Small motions (displacements and spins) about a state in equilibrium under loads that keep their direction:
    /// [`crate::normal_modes`] of it are the natural modes of the loaded structure. Points are the places of now.
    pub fn tangent_system(&self, state: &State, loads: &Loads) -> System {
        let (map, inner) = (self.map(state), self.inner(state));
        let outer = self.load_forces(state, loads);
        let unbalanced: Vec<f64> = inner.forces.iter().zip(&outer).map(|(i, o)| i - o).collect();
        let dofs: Vec<Vec<usize>> = self.elements.iter().map(super::corotated::Corotated::dofs).collect();
        let mut all = Pattern::of(6 * self.nodes.len(), &dofs).values();
        let mut own = self.pattern.clone().values();
        let mut elastic = self.elastic.iter().enumerate().map(|(at, element)| (*element, at)).peekable();
        for (at, element) in self.elements.iter().enumerate() {
            let k = elastic.next_if(|(element, _)| *element == at).and_then(|(_, local)| {
                let k = element.tangent(&inner.placed[local], &inner.local[local])?;
                Some((&k + k.transpose()) * 0.5)
            });
            let m = element.mass.as_ref().map(|mass| {
                let turned = element.turned(mass, state);
                (&turned + turned.transpose()) * 0.5
            });
            all.add(&dofs[at], k.as_ref(), m.as_ref());
            let free = free_motions(&dofs[at], &map);
            let (k_f, m_f) = (free.reduce(k.as_ref()), free.reduce(m.as_ref()));
            match &free {
                Free::Places(places) => own.add_where(places, k.as_ref(), m.as_ref()),
                Free::Combined { dofs, .. } => own.add(dofs, k_f.as_ref(), m_f.as_ref()),
            }
        }
        for (dofs, term) in self.joints.turning_arms(state, &unbalanced) {
            let free = free_motions(&dofs, &map);
            let reduced: Option<DMatrix<f64>> = free.reduce(Some(&term));
            match &free {
                Free::Places(places) => own.add_where(places, Some(&term), None),
                Free::Combined { dofs, .. } => own.add(dofs, reduced.as_ref(), None),
            }
        }
        let ((k_gg, m_gg), (k_ff, m_ff)) = (all.lower(), own.symmetric());
        let ids = self.nodes.iter().map(|node| node.id).collect();
        let points = state.places.iter().map(|place| Point3::from(*place)).collect();
        System::of_parts(ids, points, map, (k_gg, m_gg.symmetric()), [k_ff, m_ff])
    }
}
