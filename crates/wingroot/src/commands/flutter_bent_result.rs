//! `result.json` of `flutter` with large deflections.

use schemars::JsonSchema;
use serde::Serialize;

use super::flutter_result::MethodResult;

/// Flutter about the bent wing by angle of attack of its root.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct BentFlutterResult {
    /// Name of the command.
    pub(crate) command: &'static str,
    /// Name of the wing.
    pub(crate) wing: String,
    /// The file of its corrections; absent without.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) corrections: Option<String>,
    /// Highest airspeed looked at.
    pub(crate) highest_airspeed_m_s: f64,
    /// Density of the air.
    pub(crate) air_density_kg_m3: f64,
    /// Tangent modes kept at each airspeed.
    pub(crate) modes: usize,
    /// p-k of the undeformed wing, which knows no root angle.
    pub(crate) linear: MethodResult,
    /// The bent wing by root angle.
    pub(crate) root_angles: Vec<RootAngle>,
    /// Wall clock.
    pub(crate) seconds: f64,
}

/// The bent wing at an angle of attack of its root.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct RootAngle {
    /// Angle of attack of the root.
    pub(crate) alpha_deg: f64,
    /// By airspeed, each with an equilibrium of its own.
    pub(crate) points: Vec<BentAirspeed>,
    /// Whether it is unstable at the lowest of these airspeeds already: where that began is not known.
    pub(crate) is_unstable_at_lowest_airspeed: bool,
    /// Every airspeed at which a mode becomes stable or unstable.
    pub(crate) changes_of_stability: Vec<BentChange>,
    /// What the user should know.
    pub(crate) remarks: Vec<String>,
}

/// The bent wing at an airspeed.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct BentAirspeed {
    /// Airspeed.
    #[serde(rename = "V_m_s")]
    pub(crate) v_m_s: f64,
    /// Rise of the tip from its place with wind off at zero angle of attack; axes pitch with the root.
    pub(crate) tip_z_m: f64,
    /// Rise of the nose of the tip's section against its tail, over the chord, as an angle.
    pub(crate) tip_twist_deg: f64,
    /// What the air gives back of a small motion of the bent wing: at one it diverges.
    pub(crate) divergence_gain: f64,
    /// Natural frequencies of the bent wing without the air's answer, each mode followed by its shape.
    pub(crate) natural_frequencies_hz: Vec<f64>,
}

/// A mode becomes stable or unstable.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct BentChange {
    /// Airspeed.
    #[serde(rename = "V_m_s")]
    pub(crate) v_m_s: f64,
    /// Frequency; zero without oscillation.
    pub(crate) frequency_hz: f64,
    /// The mode that it is at the lowest airspeed, counted from 1.
    pub(crate) mode: usize,
    /// Rise of the tip there.
    pub(crate) tip_z_m: f64,
    /// `unstable` or `stable`.
    pub(crate) becomes: &'static str,
}
