//! What `simulate` flew, and the corrections that act at an airspeed.

use std::path::{Path, PathBuf};

use aero::Corrections;
use maneuver::{DeflectionAt, DeflectionCorrection, Run, Simulated};
use nastran::InputError;

use crate::corrections::CorrectedWing;

/// Lower and upper end of an interval at every instant.
pub(crate) type Band = Vec<[f64; 2]>;

/// A run or a maneuver flown with both models.
pub(crate) struct Flown {
    /// Its file.
    pub(crate) file: PathBuf,
    /// What moved, and what was measured.
    pub(crate) run: Run,
    /// Theory.
    pub(crate) initial: Simulated,
    /// With corrections of loads and deflections.
    pub(crate) updated: Simulated,
    /// With corrections of loads alone, if deflections are corrected.
    pub(crate) as_commanded: Option<Simulated>,
    /// What the user should know.
    pub(crate) remarks: Vec<String>,
    /// 90 % intervals of the updated model's Fz, Mx, My; none without an ensemble of wings.
    pub(crate) spread: Option<[Band; 3]>,
}

/// The corrections of loads and of deflections at the airspeed of a file; none without wind.
pub(crate) fn at_airspeed(
    file: &Path,
    v_m_s: f64,
    corrected: &CorrectedWing,
) -> Result<(Corrections, DeflectionAt), InputError> {
    if v_m_s == 0.0 {
        return Ok((Corrections::neutral(corrected.wing.correctable.len()), DeflectionAt::default()));
    }
    let corrections = corrected.schedule.at(v_m_s).map_err(|refused| {
        InputError::in_file(file, refused.message)
            .with_help("calibrate at this airspeed, or leave this file out")
    })?;
    Ok((corrections, deflection_at(file, v_m_s, corrected)?))
}

/// The corrections of deflections at an airspeed; an error names the file that flies there.
fn deflection_at(path: &Path, v_m_s: f64, corrected: &CorrectedWing) -> Result<DeflectionAt, InputError> {
    DeflectionCorrection::of_wing(&corrected.file)
        .at(v_m_s)
        .map_err(|refused| InputError { span: InputError::in_file(path, "").span, ..refused })
}
