//! The model as HDF5, for a reader in Python, MATLAB or Julia: structure and modes, boxes, pressures, corrections, and the
//! linear system that `simulate` flies.

use aero::{Corrections, Flow};
use coupling::ElasticWing;
use maneuver::Rig;

use crate::corrections::CorrectedWing;
use crate::failure::Failure;
use crate::hdf5::{self, Group, Values};
use crate::matrices::{self, rig_settings};

/// Axes, order and units, once for the whole file.
const ABOUT: &str = "wingroot: SI units, radians; x aft, y to the right tip, z up; boxes chordwise first, then spanwise; \
    six degrees of freedom a grid (three translations, three rotations)";

/// The file of a wing: with corrections at an airspeed, they and the linear systems of both models are in it.
pub(super) fn file(
    wing: &ElasticWing,
    modes: usize,
    corrected: Option<(&CorrectedWing, &Corrections, Flow)>,
) -> Result<Vec<u8>, Failure> {
    let mut groups = vec![matrices::boxes(wing)?];
    groups.extend(matrices::structure(wing, modes)?);
    if let Some((corrected, corrections, flow)) = corrected {
        groups.push(
            Group::new("corrections", "of the boxes listed in boxes/correctable: factors, and an offset of the pressure coefficient")
                .with("V_m_s", Values::list(&[flow.v_m_s]))
                .with("force", Values::list(&corrections.force))
                .with("moment", Values::list(&corrections.moment))
                .with("pressure_offset", Values::list(&corrections.pressure_offset)),
        );
        let rig = Rig::new(wing, rig_settings(&corrected.file, &corrected.wing))?;
        let neutral = Corrections::neutral(corrections.len());
        groups.push(matrices::linear_system("initial", &rig.at(flow, &neutral)?));
        groups.push(matrices::linear_system("updated", &rig.at(flow, corrections)?));
    }
    hdf5::bytes(ABOUT, &groups)
}
