//! `result.json` of `tunnel`.

use schemars::JsonSchema;
use serde::Serialize;

/// What the virtual wind tunnel measured, and how well it can be calibrated. No measurements.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct TunnelResult {
    /// Name of the command.
    pub(crate) command: &'static str,
    /// False: nothing was measured.
    pub(crate) measurements: bool,
    /// Name of the campaign.
    pub(crate) campaign: String,
    /// Seed of the noise.
    pub(crate) seed: u64,
    /// Rows of the static cases.
    pub(crate) static_rows: usize,
    /// By airspeed: straight lines over the angle of attack, truth beside the uncorrected model.
    pub(crate) truth_and_model: Vec<TruthAndModel>,
    /// By airspeed: what a calibration makes of it.
    pub(crate) calibration: Vec<CalibrationResult>,
    /// The half wing in flight, uncorrected and corrected.
    pub(crate) half_wing_uncorrected_and_corrected: HalfWing,
}

/// Truth and model at one airspeed.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct TruthAndModel {
    /// Airspeed.
    #[serde(rename = "V_m_s")]
    pub(crate) v_m_s: f64,
    /// Force Fz.
    #[serde(rename = "Fz_N")]
    pub(crate) fz: ChannelLines,
    /// Bending moment Mx.
    #[serde(rename = "Mx_Nm")]
    pub(crate) mx: ChannelLines,
    /// Torsion moment My.
    #[serde(rename = "My_Nm")]
    pub(crate) my: ChannelLines,
}

/// Straight lines of one load.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct ChannelLines {
    /// At zero angle of attack: truth and model, in the load's unit.
    pub(crate) offset: [f64; 2],
    /// Slopes of truth and model, the load's unit, 1/deg.
    pub(crate) slope_per_deg: [f64; 2],
    /// Error of the model over the largest load.
    pub(crate) relative_error: f64,
}

/// A calibration at one airspeed.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct CalibrationResult {
    /// Airspeed.
    #[serde(rename = "V_m_s")]
    pub(crate) v_m_s: f64,
    /// Objective of theory (paper 1, Eq. 8).
    pub(crate) objective_before: f64,
    /// Objective with corrections.
    pub(crate) objective_after: f64,
    /// Objective of straight lines.
    pub(crate) line_floor: f64,
    /// Cone programs solved.
    pub(crate) iterations: usize,
    /// How the fit ended.
    pub(crate) ending: String,
}

/// Steady flight of the half wing.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct HalfWing {
    /// Level flight.
    pub(crate) trim: [FlightResult; 2],
    /// Pull-up.
    pub(crate) pull_up: [FlightResult; 2],
    /// Push-down.
    pub(crate) push_down: [FlightResult; 2],
}

/// A point of steady flight.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct FlightResult {
    /// Angle of attack.
    pub(crate) alpha_deg: f64,
    /// Height of the tip.
    pub(crate) tip_deflection_m: f64,
}
