//! `result.json` of `flutter`.

use maneuver::flutter::{Crossing, first_flutter};
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
    #[serde(flatten)]
    pub(crate) speeds: MethodSpeeds,
    /// Every airspeed at which a mode becomes stable or unstable.
    pub(crate) changes_of_stability: Vec<StabilityChange>,
    /// What the user should know.
    pub(crate) remarks: Vec<String>,
}

/// What of a model has intervals, in the places that it has in [`StabilityResult`]. Changes of stability have none: the first of one
/// wing need not be of the mode that the first of another is of.
#[derive(Debug, Serialize)]
pub(crate) struct StabilitySpeeds {
    pub(crate) state_matrix: MethodSpeeds,
    pub(crate) p_k: MethodSpeeds,
    pub(crate) p_k_over_state_matrix: Option<f64>,
}

/// Where a method finds flutter and divergence.
#[derive(Debug, Clone, Copy, Serialize, JsonSchema)]
pub(crate) struct MethodSpeeds {
    /// Flutter speed; null if there is none up to the highest airspeed.
    pub(crate) flutter_speed_m_s: Option<f64>,
    /// Frequency there; null without flutter.
    pub(crate) flutter_frequency_hz: Option<f64>,
    /// Divergence speed; null if there is none up to the highest airspeed.
    pub(crate) divergence_speed_m_s: Option<f64>,
}

impl MethodSpeeds {
    /// Of changes of stability in the order of airspeeds, and a divergence speed.
    pub(crate) fn new(changes: &[Crossing], divergence_speed_m_s: Option<f64>) -> Self {
        let flutter = first_flutter(changes);
        Self {
            flutter_speed_m_s: flutter.map(|crossing| crossing.flow.v_m_s),
            flutter_frequency_hz: flutter.map(Crossing::frequency_hz),
            divergence_speed_m_s,
        }
    }
}

impl StabilitySpeeds {
    /// Of both methods.
    pub(crate) fn new(state_matrix: MethodSpeeds, p_k: MethodSpeeds) -> Self {
        let ratio = p_k.flutter_speed_m_s.zip(state_matrix.flutter_speed_m_s).map(|(p_k, a)| p_k / a);
        Self { state_matrix, p_k, p_k_over_state_matrix: ratio }
    }
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
