//! `result.json` of `deflection`.

use coupling::ByLoad;
use discover::result::BeforeAfter;
use schemars::JsonSchema;
use serde::Serialize;

/// How much of commanded deflections acts.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct DeflectionResult {
    /// Name of the command.
    pub(crate) command: &'static str,
    /// Where the corrections of the loads come from.
    pub(crate) corrections: String,
    /// What the standard errors are, in words.
    pub(crate) standard_errors: &'static str,
    /// Factors with repeats pooled.
    pub(crate) factors: Vec<FactorResult>,
    /// The doublets that were fitted.
    pub(crate) training: Vec<FittedDoublet>,
    /// The doublets that only judge.
    pub(crate) holdout: HeldOut,
    /// What the user should know.
    pub(crate) remarks: Vec<String>,
    /// Wall clock.
    pub(crate) seconds: f64,
}

/// A factor of a control surface at an airspeed and deflection.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct FactorResult {
    /// The control surface.
    pub(crate) control: String,
    /// Airspeed.
    #[serde(rename = "V_m_s")]
    pub(crate) v_m_s: f64,
    /// Commanded deflection.
    pub(crate) commanded_deg: f64,
    /// The deflection that gives the measured loads.
    pub(crate) equivalent_deg: f64,
    /// Equivalent over commanded deflection.
    pub(crate) factor: f64,
    /// Its standard error.
    pub(crate) standard_error: f64,
    /// Runs behind it.
    pub(crate) runs: usize,
}

/// A fitted doublet.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct FittedDoublet {
    /// Its file.
    pub(crate) file: String,
    /// Equivalent over commanded deflection.
    pub(crate) factor: f64,
    /// Its standard error.
    pub(crate) standard_error: f64,
    /// The part of the standard error that declared white noise makes.
    #[schemars(with = "Option<f64>")]
    pub(crate) noise_error: Option<f64>,
    /// Residual over noise with the deflection as commanded and corrected; null if the noise is not known.
    pub(crate) gap: Option<BeforeAfter<f64>>,
}

/// What the held-out doublets say.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct HeldOut {
    /// Residual of the loads over noise; null if the noise is not known or nothing is held out.
    pub(crate) gap: Option<HeldOutGap>,
    /// The same without the mean of each run, which is no part of a deflection.
    pub(crate) gap_of_changes: Option<HeldOutGap>,
    /// Each of them.
    pub(crate) runs: Vec<JudgedResult>,
}

/// Residual over noise.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct HeldOutGap {
    /// With deflections as commanded.
    pub(crate) before: f64,
    /// With deflections corrected.
    pub(crate) after: f64,
    /// What noise alone leaves.
    pub(crate) noise_alone: f64,
}

/// A held-out doublet.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct JudgedResult {
    /// Its name.
    pub(crate) run: String,
    /// Root mean square of measured less simulated loads.
    pub(crate) residual_rms: BeforeAfter<ByLoad<f64>>,
    /// The same without the mean of the run.
    pub(crate) residual_rms_of_changes: BeforeAfter<ByLoad<f64>>,
}
