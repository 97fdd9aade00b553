//! What stands in `result.json` of `calibrate` about predictions.

use calibrate::Reading;
use calibrate::posterior::next::Suggestion;
use calibrate::posterior::predictions::Quantity;
use calibrate::posterior::{AirspeedPosterior, Prediction};
use coupling::ElasticWing;
use schemars::JsonSchema;
use serde::Serialize;
use std::collections::BTreeMap;

/// Predictions of one airspeed, at the largest angle of attack that was measured.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct AirspeedPredictionsResult {
    /// Airspeed.
    #[serde(rename = "V_m_s")]
    pub(crate) v_m_s: f64,
    /// Angle of attack.
    pub(crate) alpha_deg: f64,
    /// What goes with the corrections where more than root loads was measured; `found` of `corrections.ron` has it, if airspeeds agree.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) beside_corrections: Option<BesideResult>,
    /// By quantity.
    pub(crate) predictions: Vec<PredictionResult>,
}

/// What is most likely about structure and controls.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct BesideResult {
    /// Factor on the flexibility in bending.
    pub(crate) bending_flexibility: f64,
    /// Factor on the flexibility in torsion.
    pub(crate) torsional_flexibility: f64,
    /// Factor on what each control does, by its name.
    pub(crate) controls: BTreeMap<String, f64>,
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
        Quantity::Reading(reading) => {
            let (name, unit) = match reading {
                Reading::StripLift { .. } => ("strip_lift", "N/m"),
                Reading::Shear { .. } => ("shear", "N"),
                Reading::Bending { .. } => ("bending", "N m"),
                Reading::Height { .. } => ("height", "m"),
                Reading::Twist { .. } => ("twist", "deg"),
            };
            (name, unit, Some(reading.y_over_span()), None)
        }
        Quantity::TipHeight => ("tip_height", "m", None, None),
        Quantity::ControlMx { control } => ("control_mx", "N m/deg", None, Some(control.clone())),
    }
}

/// What stands in `result.json`.
pub(crate) fn result(wing: &ElasticWing, all: &[AirspeedPosterior]) -> Vec<AirspeedPredictionsResult> {
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
    let of = |at: &AirspeedPosterior| AirspeedPredictionsResult {
        v_m_s: at.v_m_s,
        alpha_deg: at.alpha_rad.to_degrees(),
        beside_corrections: at.mean.as_ref().map(|mean| {
            let [bending, torsion] = mean.log_flexibility.map(f64::exp);
            BesideResult {
                bending_flexibility: bending,
                torsional_flexibility: torsion,
                controls: wing.control_names().into_iter().zip(mean.controls.iter().copied()).collect(),
            }
        }),
        predictions: at.predictions.iter().map(one).collect(),
    };
    all.iter().map(of).collect()
}
