//! `result.json` of `calibrate`.

use calibrate::ByFamily;
use coupling::ByLoad;
use schemars::JsonSchema;
use serde::Serialize;

use crate::commands::calibrate_predictions_result::{AirspeedPredictionsResult, SuggestionResult};
use crate::commands::result_parts::Channels;

/// What `calibrate` found. The objective is that of paper 1, Eq. 8: a weighted sum of the root mean square errors of the channels.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct CalibrateResult {
    /// Name of the command.
    pub(crate) command: &'static str,
    /// Name of the campaign.
    pub(crate) campaign: String,
    /// By airspeed, ascending; empty if one set serves all.
    pub(crate) airspeeds: Vec<AirspeedResult>,
    /// The set that serves all airspeeds, if the campaign asks for one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) common: Option<CommonResult>,
    /// Cone programs solved in all.
    pub(crate) cone_programs: usize,
    /// Offsets of days or mountings that were taken out.
    pub(crate) blocks: Vec<BlockResult>,
    /// Spread of these offsets, one standard deviation; zero without blocks.
    pub(crate) block_sigma: Channels,
    /// Standard deviation of one row; null if the noise is not known.
    pub(crate) point_sigma: Option<Channels>,
    /// Where the noise is known from, in words.
    pub(crate) noise_from: String,
    /// Probability below which a test for nonlinearity is significant.
    pub(crate) nonlinearity_level: f64,
    /// What is probably wrong with the data: units, signs, channels, rows, tares, and what is far from theory.
    pub(crate) suspicions: Vec<String>,
    /// Those of the above with which corrections are not to be trusted.
    pub(crate) defects: Vec<String>,
    /// What the campaign does not measure, and what stays at theory for it.
    pub(crate) left_open: Vec<String>,
    /// Lines of static rows that no others bear out; they were not fitted.
    pub(crate) lines_set_aside: Vec<usize>,
    /// Rows with a control deflected.
    pub(crate) rows_with_deflected_controls: usize,
    /// What the points without wind say about the wing's weight; null if there are none.
    pub(crate) weight_tare: Option<TareResult>,
    /// What the choice of the plane at the root does.
    pub(crate) root_plane: RootPlaneResult,
    /// The uniform factors on lift with small deflections, of the common set or of each airspeed; empty where the fit has them
    /// small.
    pub(crate) lift_factors_with_small_deflections: Vec<LiftFactorResult>,
    /// What the calibrated wing predicts, with intervals; empty if one set serves all airspeeds, or with large deflections.
    pub(crate) predictions: Vec<AirspeedPredictionsResult>,
    /// What to measure next, the best first; empty if it was not asked for.
    pub(crate) next: Vec<SuggestionResult>,
    /// Measured strips beside computed ones, if the campaign has `strips.csv`; never fitted.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) strips: Option<Vec<StripResult>>,
    /// Root mean square differences of these.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) strips_rms: Option<StripsRms>,
    /// Wall clock of the calibration.
    pub(crate) seconds: f64,
}

/// Corrections of one airspeed, and how good they are.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct AirspeedResult {
    /// Airspeed.
    #[serde(rename = "V_m_s")]
    pub(crate) v_m_s: f64,
    /// Objective of theory.
    pub(crate) objective_before: f64,
    /// Objective with corrections.
    pub(crate) objective_after: f64,
    /// Objective of straight lines through the data; of a wing that bends far, through what it misses.
    pub(crate) line_floor: f64,
    /// Objective that noise alone gives; null if the noise is not known.
    pub(crate) noise_floor: Option<f64>,
    /// Cone programs solved.
    pub(crate) iterations: usize,
    /// How the fit ended.
    pub(crate) ending: String,
    /// Root mean square errors of theory, by fitted channel.
    pub(crate) rmse_before: Channels,
    /// Root mean square errors with corrections.
    pub(crate) rmse_after: Channels,
    /// Root mean square errors of straight lines.
    pub(crate) line_rmse: Channels,
    /// Directions of the corrections that the data know better than the prior; null if the noise is not known.
    pub(crate) determined_directions: Option<usize>,
    /// Differences of neighbouring corrections that stand at their bound.
    pub(crate) neighbour_bound_active: usize,
    /// Tests for nonlinearity.
    pub(crate) nonlinearity: Vec<NonlinearityResult>,
    /// What the data can tell; null if the noise is not known.
    pub(crate) identifiability: Option<IdentifiabilityResult>,
    /// Every other angle left out of a fit and predicted; null with fewer than five angles.
    pub(crate) left_out: Option<LeftOutResult>,
    /// This airspeed left out and predicted from the others; null at the ends.
    pub(crate) left_out_airspeed: Option<LeftOutAirspeedResult>,
    /// The uniform factor on lift that fits best; only where the tip is fitted.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) lift_factor: Option<LiftFactorResult>,
    /// Weights of the channels in the objective; only where the tip is fitted.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) weights: Option<Channels>,
}

/// A test for nonlinearity of one channel over the angle of attack.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct NonlinearityResult {
    /// The channel.
    pub(crate) channel: &'static str,
    /// Half the second derivative of the parabola, unit of the channel over square degrees.
    pub(crate) curvature_per_deg2: f64,
    /// F statistic; null if what it is set beside is zero.
    #[schemars(with = "Option<f64>")]
    pub(crate) f: f64,
    /// Probability of an F as large without any nonlinearity; null if there is no test.
    #[schemars(with = "Option<f64>")]
    pub(crate) p_value: f64,
    /// Whether it is below the level.
    pub(crate) significant: bool,
}

/// What the data can tell of the corrections.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct IdentifiabilityResult {
    /// How many times better than the prior each direction is known, descending.
    pub(crate) singular_values: Vec<f64>,
    /// How strongly a channel hangs on a family of corrections, as a share of how strongly it hangs on all.
    pub(crate) leverage: ByFamily<Channels>,
    /// Standard deviation of the corrections after over before the data: near one, the data say nothing.
    pub(crate) remaining_spread: ByFamily<f64>,
    /// Standard deviation of the corrections after the data.
    pub(crate) posterior_sigma: ByFamily<f64>,
    /// Standard deviation of the predicted readings.
    pub(crate) predicted_sigma: Channels,
    /// Families that no channel hangs on: what the fit gives them is the prior's.
    pub(crate) undetermined: Vec<&'static str>,
}

/// Angles that were left out and predicted.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct LeftOutResult {
    /// The angles.
    pub(crate) alpha_deg: Vec<f64>,
    /// Objective of theory at them.
    pub(crate) objective_before: f64,
    /// Objective with the corrections of the other angles.
    pub(crate) objective_after: f64,
    /// Objective of straight lines through the other angles.
    pub(crate) line_error: f64,
}

/// An airspeed that was left out and predicted.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct LeftOutAirspeedResult {
    /// Objective of theory.
    pub(crate) objective_before: f64,
    /// Objective with the corrections of the other airspeeds.
    pub(crate) objective_after: f64,
}

/// One set of corrections for all airspeeds.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct CommonResult {
    /// Lowest and highest airspeed.
    #[serde(rename = "V_m_s")]
    pub(crate) v_m_s: [f64; 2],
    /// Means that were fitted.
    pub(crate) rows: usize,
    /// Objective of theory.
    pub(crate) objective_before: f64,
    /// Objective with corrections.
    pub(crate) objective_after: f64,
    /// Objective of parabolas in dynamic pressure through the data.
    pub(crate) curve_floor: f64,
    /// Weights of the channels in the objective.
    pub(crate) weights: Channels,
    /// Cone programs solved.
    pub(crate) iterations: usize,
    /// How the fit ended.
    pub(crate) ending: String,
    /// Root mean square errors of theory, by fitted channel.
    pub(crate) rmse_before: Channels,
    /// Root mean square errors with corrections.
    pub(crate) rmse_after: Channels,
    /// Root mean square errors of the parabolas.
    pub(crate) curve_rmse: Channels,
    /// Standard deviation of a row.
    pub(crate) point_sigma: Channels,
    /// The uniform factor on lift that fits best; null if nothing hangs on it.
    pub(crate) lift_factor: Option<LiftFactorResult>,
    /// Mean of the force factors, weighted by area.
    pub(crate) mean_force_factor: MeanForceFactor,
    /// Directions of the corrections that the data know better than the prior; null if the noise is not known.
    pub(crate) determined_directions: Option<usize>,
    /// Differences of neighbouring corrections that stand at their bound.
    pub(crate) neighbour_bound_active: usize,
    /// What the data can tell; null if the noise is not known.
    pub(crate) identifiability: Option<IdentifiabilityResult>,
}

/// Mean of the force factors, weighted by area.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct MeanForceFactor {
    /// Its value.
    pub(crate) value: f64,
    /// Its standard deviation if their distribution is free; null if the noise is not known.
    pub(crate) sigma_if_the_distribution_is_free: Option<f64>,
    /// The prior's; null if the noise is not known.
    pub(crate) sigma_before_the_data: Option<f64>,
}

/// The uniform factor on lift.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct LiftFactorResult {
    /// Factor on the load of every box.
    pub(crate) value: f64,
    /// Its standard deviation from the scatter of the data.
    pub(crate) sigma: f64,
    /// Correlation of neighbouring residuals.
    pub(crate) correlation_of_rows: f64,
    /// Root mean square errors that are left.
    pub(crate) rmse: Channels,
    /// By how much it would change from no to the largest deflection of the tip; null if the tip is not fitted, or the data do not
    /// tell the two apart.
    pub(crate) change_up_to_largest_deflection: Option<TrendResult>,
    /// Free zeros of the tip's reading.
    pub(crate) tip_zeros: Vec<TipZeroResult>,
}

/// A change with its standard deviation.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct TrendResult {
    /// The change.
    pub(crate) value: f64,
    /// Its standard deviation.
    pub(crate) sigma: f64,
}

/// A free zero of the tip's reading.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct TipZeroResult {
    /// Day or mounting; null for points without one.
    pub(crate) block: Option<String>,
    /// What the reading shows when the tip has not moved.
    pub(crate) tip_zero_m: f64,
    /// Its standard deviation.
    pub(crate) sigma_m: f64,
}

/// The offset of a day or mounting.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct BlockResult {
    /// Its name.
    pub(crate) block: String,
    /// The offset.
    pub(crate) offset: Channels,
}

/// Points without wind beside the modelled weight.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct TareResult {
    /// Rows.
    pub(crate) points: usize,
    /// Root mean square of measured minus modelled weight.
    pub(crate) rms: ByLoad<f64>,
    /// The same over the standard deviation of a row; null if the noise is not known.
    pub(crate) rms_over_noise: Option<ByLoad<f64>>,
}

/// Lift slopes of the uncorrected wing with and without the plane at its root.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct RootPlaneResult {
    /// The plane.
    pub(crate) choice: String,
    /// Rigid lift slope.
    pub(crate) lift_slope_per_rad: f64,
    /// Rigid lift slope with a free root.
    pub(crate) lift_slope_per_rad_without_plane: f64,
    /// Lift slope of the elastic wing, 1/rad.
    pub(crate) elastic_lift_slope_per_rad_at_highest_airspeed: f64,
}

/// A measured strip, cl/CL.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct StripResult {
    /// Place along the half span, 0 at the root.
    pub(crate) two_y_over_b: f64,
    /// Measured.
    #[serde(rename = "measured_cl_over_CL")]
    pub(crate) measured: f64,
    /// Theory.
    pub(crate) initial: f64,
    /// With corrections.
    pub(crate) updated: f64,
}

/// Root mean square differences of the strips, cl/CL.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct StripsRms {
    /// What they are.
    pub(crate) note: &'static str,
    /// Airspeed.
    #[serde(rename = "V_m_s")]
    pub(crate) v_m_s: f64,
    /// Angle of attack.
    pub(crate) alpha_deg: f64,
    /// Theory.
    pub(crate) initial: f64,
    /// With corrections.
    pub(crate) updated: f64,
}
