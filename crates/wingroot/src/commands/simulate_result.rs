//! `result.json` of `simulate`.

use std::collections::BTreeMap;

use coupling::ByLoad;
use schemars::JsonSchema;
use serde::Serialize;

use crate::commands::result_parts::{Loads, Models};

/// Runs and maneuvers flown by both models, set beside what was measured.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct SimulateResult {
    /// Name of the command.
    pub(crate) command: &'static str,
    /// Where the corrections come from.
    pub(crate) corrections: String,
    /// Whether the wing's file corrects commanded deflections.
    pub(crate) deflection_correction: bool,
    /// Modes kept.
    pub(crate) modes: usize,
    /// The approximation of the unsteady air; null if it is quasi-steady.
    pub(crate) air: Option<AirResult>,
    /// Where the wings are from whose spread intervals are; null without them.
    pub(crate) intervals_from: Option<String>,
    /// Runs, then maneuvers.
    pub(crate) runs: Vec<RunResult>,
    /// Effects that the updated model flies with; left out if the wing has none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) effects: Option<Vec<EffectResult>>,
    /// Effects that were switched off; left out if the wing has none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) without: Option<Vec<String>>,
    /// Wall clock.
    pub(crate) seconds: f64,
}

/// How far the rational approximation is from the doublet lattice.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct AirResult {
    /// Reduced frequencies at which they are compared.
    pub(crate) reduced_frequencies: Vec<f64>,
    /// Poles of the approximation.
    pub(crate) poles: Vec<f64>,
    /// Largest error of a load, percent of its largest value.
    pub(crate) largest_error_percent_by_load: BTreeMap<String, f64>,
    /// Largest error by what moves, percent.
    pub(crate) largest_error_percent_by_motion: BTreeMap<String, f64>,
}

/// A run or maneuver.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct RunResult {
    /// Its file.
    pub(crate) file: String,
    /// Airspeed.
    #[serde(rename = "V_m_s")]
    pub(crate) v_m_s: f64,
    /// Its length.
    pub(crate) samples: usize,
    /// Root mean square of measured less simulated loads; null without measurement.
    pub(crate) residual_rms: Models<Loads>,
    /// What the user should know.
    pub(crate) remarks: Vec<String>,
    /// Largest half of a 90 % interval of the updated model's loads, as corrections, stiffness and control surfaces are known; null
    /// without an ensemble of wings.
    pub(crate) largest_half_interval_90: Option<ByLoad<f64>>,
    /// The residual as a share of the load's variation, percent; null without measurement or for a load that never moves.
    pub(crate) raw_percent: Models<Option<ByLoad<Option<f64>>>>,
}

/// An effect of the wing's file.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct EffectResult {
    /// Its name.
    pub(crate) name: String,
    /// Its form; empty for the usual one.
    pub(crate) form: String,
    /// Values by parameter, in the units of their names.
    pub(crate) parameters: BTreeMap<String, f64>,
}
