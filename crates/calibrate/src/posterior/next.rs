//! What to measure next: by how much each sensor would narrow the interval of one prediction.

use super::predictions::{Quantity, section_rows};
use super::prior::Modes;
use super::{Posterior, gradient_of};
use crate::calibration::Calibration;
use aero::Flow;
use coupling::wing_file::CorrectionPrior;
use coupling::{CouplingError, ElasticWing, SteadyCase};

/// Places of strain bridges along the span, as shares of it.
const BRIDGES: [f64; 4] = [0.2, 0.4, 0.6, 0.8];
/// A strain bridge reads bending to this share of its largest reading.
const BRIDGE_SHARE: f64 = 0.01;
/// A marker at the tip reads its height to this, m, where the campaign declares nothing.
const TIP_M: f64 = 1e-3;
/// Deflections of static points, deg.
const DEFLECTED_DEG: [f64; 2] = [-10.0, 10.0];

/// A measurement that was not made, and what it would do.
#[derive(Debug, Clone, PartialEq)]
pub struct Suggestion {
    /// What to measure.
    pub measure: String,
    /// Standard deviation of the prediction with the data there are.
    pub sigma: f64,
    /// The same with this measurement beside them.
    pub sigma_then: f64,
}

/// Ranks sensors and points by how much they would narrow a prediction at the highest airspeed, the best first.
///
/// # Errors
/// If the wing cannot be solved.
pub fn rank(
    wing: &ElasticWing,
    calibration: &Calibration,
    prior: &CorrectionPrior,
    wanted: &Quantity,
) -> Result<Vec<Suggestion>, CouplingError> {
    let Some(at) = calibration.airspeeds.last() else { return Ok(Vec::new()) };
    let modes = Modes::new(wing, prior);
    let flow = Flow { v_m_s: at.data.v_m_s, rho_kg_m3: calibration.rho_kg_m3 };
    let corrected = wing.at(flow, &at.corrections)?;
    let posterior = Posterior::new(wing, calibration, at, prior, &modes)?;
    let alphas: Vec<f64> = at.data.angles.iter().map(|angle| angle.alpha_rad).collect();
    let largest = SteadyCase::new(flow, alphas.iter().copied().fold(f64::NEG_INFINITY, f64::max));
    let gradient = gradient_of(wing, &corrected, &largest, wanted, &modes, prior);
    let sigma = posterior.sigma_with(&[], &gradient);
    let data = &calibration.data;
    let noise = data.point_sigma.unwrap_or(at.line.rmse);
    let case = |alpha: &f64| SteadyCase::new(flow, *alpha);
    let mut found = Vec::new();
    let mut suggest = |measure: String, rows: Vec<Vec<f64>>| {
        let sigma_then = posterior.sigma_with(&rows, &gradient);
        found.push(Suggestion { measure, sigma, sigma_then });
    };
    if !data.channels[crate::campaign::TIP] {
        let tip_m = if noise[3] > 0.0 { noise[3] } else { TIP_M };
        let row = |alpha| {
            scaled(gradient_of(wing, &corrected, &case(alpha), &Quantity::TipHeight, &modes, prior), tip_m)
        };
        suggest(
            format!(
                "the tip's height (to {:.1} mm, its wind-off zero known) at the angles measured",
                1e3 * tip_m
            ),
            alphas.iter().map(row).collect(),
        );
    }
    for y_norm in BRIDGES {
        let of = |case: &SteadyCase| corrected.readings(case, &section_rows(wing, y_norm)[1]);
        let readings: Vec<_> = alphas.iter().map(|alpha| of(&case(alpha))).collect();
        let most = readings.iter().map(|read| read.values[0].abs()).fold(f64::MIN_POSITIVE, f64::max);
        suggest(
            format!("bending by strain (to 1 %) at {y_norm:.1} of the span, at the angles measured"),
            readings.iter().map(|read| scaled(modes.gradient(read, 0, prior), BRIDGE_SHARE * most)).collect(),
        );
    }
    let middle = alphas[alphas.len() / 2];
    for (c, control) in wing.control_names().into_iter().enumerate() {
        let mut rows = Vec::new();
        for deflection_deg in DEFLECTED_DEG {
            let mut deflected = case(&middle);
            deflected.controls_rad = vec![0.0; wing.controls.len()];
            deflected.controls_rad[c] = f64::to_radians(deflection_deg);
            let read = corrected.readings(&deflected, &wing.root_rows);
            let channels = (0..3).filter(|&channel| data.channels[channel]);
            rows.extend(
                channels.map(|channel| scaled(modes.gradient(&read, channel, prior), noise[channel])),
            );
        }
        suggest(format!("root loads with {control} at -10 and 10 degrees"), rows);
    }
    found.sort_by(|a, b| a.sigma_then.total_cmp(&b.sigma_then));
    Ok(found)
}

fn scaled(row: Vec<f64>, sigma: f64) -> Vec<f64> {
    row.into_iter().map(|value| value / sigma.max(f64::MIN_POSITIVE)).collect()
}
