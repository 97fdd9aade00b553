//! A load set that acts on a trimmed deck beside air and inertia (LOAD of a subcase): thrust, a store's forces, weight as GRAV.

use crate::error::AircraftError;
use faer::Mat;
use nastran::{BulkData, InputError};
use structure::{Flexibility, System, loads_of};

/// The load and what it does to the structure.
#[derive(Debug)]
pub(crate) struct GivenLoad {
    /// Forces and moments, g-set.
    on_grids: Vec<f64>,
    /// Displacement of the s-set, held at the SUPORT motions.
    pub(crate) displacement: Vec<f64>,
    /// Its work on each SUPORT motion.
    pub(crate) on_motions: Vec<f64>,
}

impl GivenLoad {
    /// Of a set, on the structure that is free and held at the SUPORT motions `d`.
    ///
    /// # Errors
    /// If the set is not there, has loads that are not read or motions that are enforced, or the held structure can move.
    fn new(
        bulk: &BulkData,
        set: u32,
        [free, held]: [&System; 2],
        d: &Mat<f64>,
        s_dofs: &[usize],
    ) -> Result<Self, AircraftError> {
        if let Some(card) = bulk.enforced.iter().find(|card| card.set == set) {
            let message = format!("SPCD of set {set} enforces a motion, which a trim does not know");
            return Err(InputError::at(&card.span, message)
                .with_help("take it out of the set that LOAD selects")
                .into());
        }
        let forces = free.forces_of(&loads_of(bulk, set)?);
        let displaced = Flexibility::new(held)?.displacements(held.reduce(forces.as_ref()).as_ref());
        let displaced = held.expand_at(displaced.as_ref(), s_dofs);
        let on_motions = d.transpose() * &forces;
        Ok(Self {
            on_grids: forces.col(0).iter().copied().collect(),
            displacement: displaced.col(0).iter().copied().collect(),
            on_motions: on_motions.col(0).iter().copied().collect(),
        })
    }

    /// Of a set, if there is one, taken off the inertia loads (g-set by variables): what inertia is to the other variables, a load is to the first,
    /// which is always there.
    ///
    /// # Errors
    /// As [`GivenLoad::new`].
    pub(crate) fn relieving(
        bulk: &BulkData,
        set: Option<u32>,
        structures: [&System; 2],
        d: &Mat<f64>,
        s_dofs: &[usize],
        inertia: &mut Mat<f64>,
    ) -> Result<Option<Self>, AircraftError> {
        let load = set.map(|set| Self::new(bulk, set, structures, d, s_dofs)).transpose()?;
        for (i, force) in load.iter().flat_map(|load| load.on_grids.iter().enumerate()) {
            inertia[(i, 0)] -= force;
        }
        Ok(load)
    }
}
