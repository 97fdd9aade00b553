//! The stiffness of the modes split into what resists torsion and the rest.
//!
//! Stiffness is linear in the torsion constants of beams and rods and in the shear moduli of plies, so its part in
//! proportion to them is a difference of two assemblies. Isotropic plates and solids cannot be split: they count as bending.

use crate::rig::{Rig, RigError};
use coupling::CouplingError;
use faer::{Mat, Scale};
use nastran::BulkData;
use structure::{Model, System};

/// The share by which torsion is made stiffer for the difference: no small number, as nothing is curved.
const SHARE: f64 = 1.0;

/// Both parts are m by m, in (rad/s)²; their sum is the stiffness of the modes.
#[derive(Debug, Clone, PartialEq)]
pub struct StiffnessParts {
    /// Of bending, and all that is not torsion.
    pub bending: Mat<f64>,
    /// Of torsion.
    pub torsion: Mat<f64>,
}

impl StiffnessParts {
    /// The parts of a rig whose structure is `bulk`; none for a wing without structure.
    ///
    /// # Errors
    /// If the deck is not the rig's: it cannot be assembled, or has other grids.
    pub fn new(rig: &Rig<'_>, bulk: &BulkData) -> Result<Option<Self>, RigError> {
        let (shapes, omega) = (&rig.operators.shapes_g, &rig.operators.omega_rad_s);
        let Some((plain, _)) = rig.wing.structure.as_ref().filter(|_| !omega.is_empty()) else {
            return Ok(None);
        };
        let model = Model::from_bulk(&stiffer_in_torsion(bulk)).map_err(CouplingError::from)?;
        let stiff = System::assemble(&model).map_err(CouplingError::from)?;
        let modal = |system: &System| shapes.transpose() * system.elastic_loads(shapes.as_ref());
        let torsion = Scale(1.0 / SHARE) * (modal(&stiff) - modal(plain));
        let m = omega.len();
        let bending = Mat::from_fn(m, m, |i, j| {
            let whole = if i == j { omega[i] * omega[i] } else { 0.0 };
            whole - torsion[(i, j)]
        });
        Ok(Some(Self { bending, torsion }))
    }
}

fn stiffer_in_torsion(bulk: &BulkData) -> BulkData {
    let mut stiff = bulk.clone();
    for property in stiff.beam_properties.values_mut() {
        property.stations.iter_mut().for_each(|station| station.j *= 1.0 + SHARE);
    }
    stiff.rod_properties.values_mut().for_each(|rod| rod.j *= 1.0 + SHARE);
    stiff.ply_materials.values_mut().for_each(|ply| ply.g12 *= 1.0 + SHARE);
    // the last of G11, G12, G13, G22, G23, G33
    stiff.plane_materials.values_mut().for_each(|plane| plane.g[5] *= 1.0 + SHARE);
    stiff
}
