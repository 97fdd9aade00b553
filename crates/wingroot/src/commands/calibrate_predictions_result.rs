//! What stands in `result.json` of `calibrate` about predictions.

use calibrate::posterior::next::Suggestion;
use calibrate::posterior::predictions::Quantity;
use calibrate::posterior::{AirspeedPredictions, Prediction};
use schemars::JsonSchema;
use serde::Serialize;

/// Predictions of one airspeed, at the largest angle of attack that was measured.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct AirspeedPredictionsResult {
    /// Airspeed.
    #[serde(rename = "V_m_s")]
    pub(crate) v_m_s: f64,
    /// Angle of attack.
    pub(crate) alpha_deg: f64,
    /// By quantity.
    pub(crate) predictions: Vec<PredictionResult>,
}

/// A prediction with its 90 % interval.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct PredictionResult {
    /// `strip_lift`, `shear`, `bending` (air loads outboard of a section), `tip_height`, `control_mx` (root bending by a degree).
    pub(crate) quantity: &'static str,
    /// Unit of the numbers.
    pub(crate) unit: &'static str,
    /// Place along the span, from root to tip; only of loads along it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) y_over_span: Option<f64>,
    /// Name of the control; only of what a control does.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) control: Option<String>,
    /// By theory.
    pub(crate) theory: f64,
    /// By the calibrated wing.
    pub(crate) value: f64,
    /// Lower end of the 90 % interval.
    pub(crate) low: f64,
    /// Upper end.
    pub(crate) high: f64,
    /// One standard deviation.
    pub(crate) sigma: f64,
    /// One standard deviation before the data, by the prior of the wing's file.
    pub(crate) prior_sigma: f64,
    /// Share of the prior's variance that the data take away: near zero, the interval is the prior's.
    pub(crate) decided_by_data: f64,
}

/// A measurement that was not made.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct SuggestionResult {
    /// What to measure.
    pub(crate) measure: String,
    /// Standard deviation of the prediction with the data there are, in its unit.
    pub(crate) sigma: f64,
    /// The same with this measurement beside them.
    pub(crate) sigma_then: f64,
}

/// What stands in `result.json`.
pub(crate) fn suggestions(all: &[Suggestion]) -> Vec<SuggestionResult> {
    let one = |s: &Suggestion| SuggestionResult {
        measure: s.measure.clone(),
        sigma: s.sigma,
        sigma_then: s.sigma_then,
    };
    all.iter().map(one).collect()
}

/// Name, unit, place and control.
pub(crate) fn named(quantity: &Quantity) -> (&'static str, &'static str, Option<f64>, Option<String>) {
    match quantity {
        Quantity::StripLift { y_norm } => ("strip_lift", "N/m", Some(*y_norm), None),
        Quantity::Shear { y_norm } => ("shear", "N", Some(*y_norm), None),
        Quantity::Bending { y_norm } => ("bending", "N m", Some(*y_norm), None),
        Quantity::TipHeight => ("tip_height", "m", None, None),
        Quantity::ControlMx { control } => ("control_mx", "N m/deg", None, Some(control.clone())),
    }
}

/// What stands in `result.json`.
pub(crate) fn result(all: &[AirspeedPredictions]) -> Vec<AirspeedPredictionsResult> {
    let one = |prediction: &Prediction| {
        let (quantity, unit, y_over_span, control) = named(&prediction.quantity);
        let [low, high] = prediction.interval();
        PredictionResult {
            quantity,
            unit,
            y_over_span,
            control,
            theory: prediction.theory,
            value: prediction.value,
            low,
            high,
            sigma: prediction.sigma,
            prior_sigma: prediction.prior_sigma,
            decided_by_data: prediction.decided(),
        }
    };
    let of = |at: &AirspeedPredictions| AirspeedPredictionsResult {
        v_m_s: at.v_m_s,
        alpha_deg: at.alpha_rad.to_degrees(),
        predictions: at.predictions.iter().map(one).collect(),
    };
    all.iter().map(of).collect()
}
