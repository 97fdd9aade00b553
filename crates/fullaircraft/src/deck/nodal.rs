//! Loads of a trimmed deck at its grids: the air's where the splines put them, inertia `-M a` of the trim's accelerations (gravity is in
//! them); thrust is not known to a trim. All is in the deck's units and the basic system.

use super::trim::{TrimDeck, TrimmedDeck};
use crate::stations::nodal::NodalLoads;

impl TrimDeck {
    /// Loads of a trim at all grids, g-set in the deck's units.
    pub fn nodal_loads(&self, trimmed: &TrimmedDeck) -> NodalLoads {
        let grids = &self.grids;
        let count = grids.mass_times.nrows();
        let mut air = vec![0.0; count];
        for (dof, load) in grids.s_dofs.iter().zip(&trimmed.on_grids) {
            air[*dof] = *load;
        }
        let values: Vec<f64> = self.variables.iter().map(|name| trimmed.values[name]).collect();
        let inertia = (0..count).map(|dof| {
            -values.iter().enumerate().map(|(j, value)| grids.mass_times[(dof, j)] * value).sum::<f64>()
        });
        NodalLoads { air, inertia: inertia.collect(), thrust: vec![0.0; count], damping: vec![0.0; count] }
    }

    /// Slope of the rigid deck's vertical force (basic z) over dynamic pressure and reference area, 1/rad; nothing without ANGLEA.
    pub fn lift_slope(&self) -> Option<f64> {
        let alpha = self.variables.iter().position(|name| name == "ANGLEA")?;
        let up = self.grids.s_dofs.iter().enumerate().filter(|(_, dof)| *dof % 6 == 2);
        let forces = self.rigid_loads();
        Some(up.map(|(row, _)| forces[(row, alpha)]).sum::<f64>() / self.aeros().area)
    }
}
