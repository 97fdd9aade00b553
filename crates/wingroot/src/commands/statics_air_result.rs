//! `result.json` of `statics --wing`.

use coupling::ByLoad;
use schemars::JsonSchema;
use serde::Serialize;

/// A wing in steady air.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct StaticsAirResult {
    /// Name of the command.
    pub(crate) command: &'static str,
    /// Name of the wing.
    pub(crate) wing: String,
    /// Whether deflections are large.
    pub(crate) large_deflections: bool,
    /// Angle of attack of the root.
    pub(crate) alpha_deg: f64,
    /// Density of the air.
    pub(crate) rho_kg_m3: f64,
    /// By airspeed.
    pub(crate) points: Vec<AirPoint>,
    /// Wall clock.
    pub(crate) seconds: f64,
}

/// An airspeed.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub(crate) struct AirPoint {
    /// Airspeed.
    #[serde(rename = "V_m_s")]
    pub(crate) v_m_s: f64,
    /// With small deflections; null at and beyond the divergence of linear theory.
    pub(crate) linear: Option<Bent>,
    /// With large deflections.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) large: Option<Bent>,
    /// Newton's iterations of large deflections.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) iterations: Option<usize>,
    /// What the air gives back of a small motion of the bent wing: at one it diverges.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) divergence_gain: Option<f64>,
}

/// The wing as it stands in the air, against its place with wind off at zero angle of attack; axes pitch with the root.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
pub(crate) struct Bent {
    /// Rise of the tip.
    pub(crate) tip_z_m: f64,
    /// Motion of the tip outboard, negative where bending draws it in; zero in linear theory.
    pub(crate) tip_y_m: f64,
    /// Rise of the nose of the tip's section against its tail, over the chord, as an angle.
    pub(crate) tip_twist_deg: f64,
    /// What the balance feels.
    pub(crate) root: ByLoad<f64>,
}
