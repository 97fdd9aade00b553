//! By how much the mean axes of a trimmed deck pitch against its SUPORT grid.
//!
//! ```text
//! r = (Dᵀ M D)^-1 Dᵀ M u      u: the deformation held at the SUPORT motions D; without the rigid motion D r it has no momentum
//! ```

use crate::deck::structure::Reduced;
use aero::StreamAxes;
use faer::Mat;
use nalgebra::Vector3;

/// Nose-up angle of the mean axes against the SUPORT grid: that of the rigid motion with the momentum of the deformation.
#[derive(Debug)]
pub(crate) struct MeanPitch {
    /// By loads on the s-set, rad per unit.
    by_load: Vec<f64>,
    /// By each variable's inertia loads, to be taken off.
    by_inertia: Vec<f64>,
}

impl MeanPitch {
    /// None if no SUPORT motion pitches the aircraft.
    pub(crate) fn new(structure: &Reduced, rotations: &[Vector3<f64>], stream: &StreamAxes) -> Option<Self> {
        let shares: Vec<f64> = rotations.iter().map(|axis| axis.dot(&stream.axes.column(1))).collect();
        let summed = |of: &Mat<f64>| -> Vec<f64> {
            let at =
                |column: usize| shares.iter().enumerate().map(|(j, share)| share * of[(j, column)]).sum();
            (0..of.ncols()).map(at).collect()
        };
        shares.iter().any(|share| share.abs() > 1e-9).then(|| Self {
            by_load: summed(&structure.mean_by_load),
            by_inertia: summed(&structure.mean_by_inertia),
        })
    }

    /// The angle, rad, under loads on the s-set and the values of the variables.
    pub(crate) fn angle_rad(&self, loads: &[f64], values: &[f64]) -> f64 {
        let sum = |by: &[f64], of: &[f64]| -> f64 { by.iter().zip(of).map(|(by, of)| by * of).sum() };
        sum(&self.by_load, loads) - sum(&self.by_inertia, values)
    }
}
