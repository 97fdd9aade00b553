//! `result.json` of `flutter`.

use schemars::JsonSchema;
use serde::Serialize;

use crate::ensemble::Intervals;

/// Flutter and divergence of the wing without and with corrections.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct FlutterResult {
    /// Name of the command.
    pub(crate) command: &'static str,
    /// Where the corrections come from.
    pub(crate) corrections: String,
    /// First and last airspeed of the corrections; outside of them the nearest are held.
    pub(crate) corrections_held_outside_m_s: [f64; 2],
    /// Highest airspeed looked at.
    pub(crate) highest_airspeed_m_s: f64,
    /// Density of the air.
    pub(crate) air_density_kg_m3: f64,
    /// Modes kept.
    pub(crate) modes: usize,
    /// Theory.
    pub(crate) initial: StabilityResult,
    /// With corrections.
    pub(crate) updated: StabilityResult,
    /// What is not certain of the updated wing; null without an ensemble of wings beside the corrections. Where not every wing of it
    /// has a speed, there is no interval.
    pub(crate) intervals_90: Option<Intervals>,
    /// Wall clock.
    pub(crate) seconds: f64,
}

/// One model by two methods.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct StabilityResult {
    /// Eigenvalues of the model that `simulate` flies.
    pub(crate) state_matrix: MethodResult,
    /// The p-k method on the doublet lattice.
    pub(crate) p_k: MethodResult,
    /// Ratio of their flutter speeds; null if one of them finds none.
    pub(crate) p_k_over_state_matrix: Option<f64>,
}

/// What a method finds.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct MethodResult {
    /// Flutter speed; null if there is none up to the highest airspeed.
    pub(crate) flutter_speed_m_s: Option<f64>,
    /// Frequency there; null without flutter.
    pub(crate) flutter_frequency_hz: Option<f64>,
    /// Divergence speed; null if there is none up to the highest airspeed.
    pub(crate) divergence_speed_m_s: Option<f64>,
    /// Every airspeed at which a mode becomes stable or unstable.
    pub(crate) changes_of_stability: Vec<StabilityChange>,
    /// What the user should know.
    pub(crate) remarks: Vec<String>,
}

/// A mode becomes stable or unstable.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct StabilityChange {
    /// Airspeed.
    #[serde(rename = "V_m_s")]
    pub(crate) v_m_s: f64,
    /// Frequency.
    pub(crate) frequency_hz: f64,
    /// The mode, counted from 1.
    pub(crate) mode: usize,
    /// `unstable` or `stable`.
    pub(crate) becomes: &'static str,
}
