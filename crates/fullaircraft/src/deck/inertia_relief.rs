//! Inertia relief (PARAM INREL = -1): a free structure accelerates under its loads, and these and its own inertia deform it.
//!
//! ```text
//! a = (Dᵀ M D)^-1 Dᵀ f      accelerations of the SUPORT motions D
//! f - M D a                 what deforms: nothing is left for the SUPORT to hold
//! ```

use super::structure::{assembled, carried, support_motions};
use faer::linalg::solvers::Solve;
use faer::{Mat, MatRef};
use nastran::{BulkData, InputError};
use structure::System;

/// Acceleration (m/s^2, rad/s^2) by grid and component of SUPORT.
pub type Accelerations = Vec<(u32, u8, f64)>;

/// A deck's structure, free in the motions of its SUPORT.
#[derive(Debug)]
pub struct InertiaRelief {
    free: System,
    motions: Mat<f64>,
    /// Grid and component of each motion.
    names: Vec<(u32, u8)>,
}

impl InertiaRelief {
    /// Of the deck under the boundary conditions that it has.
    ///
    /// # Errors
    /// If it has no SUPORT, or a SUPORT that holds no rigid body.
    pub fn new(bulk: &BulkData) -> Result<Self, InputError> {
        let free = assembled(bulk)?;
        let motions = carried(bulk, &free, &support_motions(bulk, &free)?)?;
        let components = |support: &nastran::Suport| {
            let grid = support.grid;
            support.components.iter().map(move |component| (grid, *component)).collect::<Vec<_>>()
        };
        let names: Vec<(u32, u8)> = bulk.supports.iter().flat_map(components).collect();
        if names.is_empty() {
            let error =
                InputError::general("PARAM INREL = -1 asks for inertia relief, and there is no SUPORT");
            return Err(error.with_help("name the motions in which the structure is free by SUPORT"));
        }
        Ok(Self { free, motions, names })
    }

    /// The inertia (N, N m; g-set, one column) of the whole under loads, and how it accelerates.
    ///
    /// # Errors
    /// If there is no mass to accelerate in one of the motions.
    pub fn inertia(&self, loads: MatRef<'_, f64>) -> Result<(Mat<f64>, Accelerations), InputError> {
        let carried = self.free.inertia_loads(self.motions.as_ref());
        let mass = self.motions.transpose() * &carried;
        let accelerations = mass.partial_piv_lu().solve(self.motions.transpose() * loads);
        if !accelerations.col_iter().all(|column| column.iter().all(|value| value.is_finite())) {
            let error =
                InputError::general("a motion of SUPORT moves no mass: inertia relief has no acceleration");
            return Err(
                error.with_help("give the structure mass (density, NSM, CONM2), or leave out PARAM INREL")
            );
        }
        let named = self.names.iter().zip(accelerations.col(0).iter());
        let by_name = named.map(|((grid, component), value)| (*grid, *component, *value)).collect();
        Ok((-(carried * accelerations), by_name))
    }
}
