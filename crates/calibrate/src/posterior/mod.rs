//! How far to trust what the corrected wing predicts: the distribution of corrections that the data leave, and the interval of
//! every prediction.
//!
//! Corrections about theory are Gaussian before the data ([`CorrectionPrior`]). Linearised at the calibrated corrections, data
//! `d = J z + noise` leave `z` with the covariance `(I + J' N⁻¹ J)⁻¹` in units of the prior (Tarantola, Inverse Problem Theory,
//! 2005, Section 3.2), and a prediction with gradient `g` has the variance `g' C g`. Its centre is the calibrated wing.

pub mod next;
pub mod predictions;
mod prior;

use crate::calibration::{AirspeedCalibration, Calibration};
use aero::{Corrections, Flow};
use coupling::wing_file::CorrectionPrior;
use coupling::{CouplingError, ElasticWing, Readings, SteadyCase, SteadyOperator};
use faer::linalg::solvers::Solve;
use faer::{Mat, Side};
use predictions::{Quantity, quantities, section_rows};
use prior::Modes;

/// Half of a 90 % interval of a Gaussian in standard deviations.
const HALF_90: f64 = 1.644_853_627;

/// A prediction with its interval.
#[derive(Debug, Clone, PartialEq)]
pub struct Prediction {
    /// What is predicted.
    pub quantity: Quantity,
    /// By theory.
    pub theory: f64,
    /// By the calibrated wing.
    pub value: f64,
    /// Standard deviation before the data, about the calibrated wing.
    pub prior_sigma: f64,
    /// Standard deviation with the data.
    pub sigma: f64,
}

impl Prediction {
    /// The 90 % interval.
    pub fn interval(&self) -> [f64; 2] {
        [self.value - HALF_90 * self.sigma, self.value + HALF_90 * self.sigma]
    }

    /// Share of the prior's variance that the data took away.
    pub fn decided(&self) -> f64 {
        1.0 - (self.sigma / self.prior_sigma.max(f64::MIN_POSITIVE)).powi(2)
    }
}

/// Predictions of one airspeed.
#[derive(Debug, Clone, PartialEq)]
pub struct AirspeedPredictions {
    /// Airspeed, m/s.
    pub v_m_s: f64,
    /// Angle of attack of all predictions, the largest that was measured, rad.
    pub alpha_rad: f64,
    /// By quantity.
    pub predictions: Vec<Prediction>,
}

/// Intervals of what every calibrated airspeed predicts.
///
/// # Errors
/// If the wing cannot be solved.
pub fn intervals(
    wing: &ElasticWing,
    calibration: &Calibration,
    prior: &CorrectionPrior,
) -> Result<Vec<AirspeedPredictions>, CouplingError> {
    let modes = Modes::new(wing, prior);
    calibration.airspeeds.iter().map(|at| at_airspeed(wing, calibration, at, prior, &modes)).collect()
}

fn at_airspeed(
    wing: &ElasticWing,
    calibration: &Calibration,
    at: &AirspeedCalibration,
    prior: &CorrectionPrior,
    modes: &Modes,
) -> Result<AirspeedPredictions, CouplingError> {
    let flow = Flow { v_m_s: at.data.v_m_s, rho_kg_m3: calibration.rho_kg_m3 };
    let corrected = wing.at(flow, &at.corrections)?;
    let posterior = Posterior::new(wing, calibration, at, prior, modes)?;
    let alpha_rad = at.data.angles.iter().map(|angle| angle.alpha_rad).fold(f64::NEG_INFINITY, f64::max);
    let (listed, rows) = quantities(wing);
    let case = SteadyCase::new(flow, alpha_rad);
    let neutral = Corrections::neutral(wing.correctable.len());
    let theory = wing.at(flow, &neutral)?;
    let read = corrected.readings(&case, &rows);
    let by_theory = theory.readings(&case, &rows).values;
    let mut predictions: Vec<Prediction> = listed
        .into_iter()
        .enumerate()
        .map(|(r, quantity)| {
            posterior.prediction(quantity, [by_theory[r], read.values[r]], &modes.gradient(&read, r, prior))
        })
        .collect();
    for control in wing.control_names() {
        let quantity = Quantity::ControlMx { control };
        let [of_theory, value] =
            [&theory, &corrected].map(|operator| value_of(wing, operator, &case, &quantity));
        let gradient = gradient_of(wing, &corrected, &case, &quantity, modes, prior);
        predictions.push(posterior.prediction(quantity, [of_theory, value], &gradient));
    }
    Ok(AirspeedPredictions { v_m_s: flow.v_m_s, alpha_rad, predictions })
}

/// What is read in a case for a quantity: rows on the box loads, and whether the case with the control by a degree less the case
/// without it is meant. The tip's height has no row.
fn read_of(wing: &ElasticWing, quantity: &Quantity) -> (Mat<f64>, Option<usize>) {
    let root = |row: usize| Mat::from_fn(1, wing.root_rows.ncols(), |_, k| wing.root_rows[(row, k)]);
    match quantity {
        Quantity::Shear { y_norm } => (section_rows(wing, *y_norm)[0].clone(), None),
        Quantity::Bending { y_norm } => (section_rows(wing, *y_norm)[1].clone(), None),
        Quantity::TipHeight => (Mat::zeros(0, wing.root_rows.ncols()), None),
        Quantity::ControlMx { control } => {
            (root(1), wing.control_names().iter().position(|name| name == control))
        }
        Quantity::StripLift { y_norm } => {
            let (listed, rows) = quantities(wing);
            let of =
                listed.iter().position(|one| matches!(one, Quantity::StripLift { y_norm: y } if y == y_norm));
            (Mat::from_fn(1, rows.ncols(), |_, k| of.map_or(0.0, |r| rows[(r, k)])), None)
        }
    }
}

/// Readings of a quantity in a case, and in the case that is taken from it.
fn readings_of(
    wing: &ElasticWing,
    operator: &SteadyOperator<'_>,
    case: &SteadyCase,
    quantity: &Quantity,
) -> (Readings, Option<Readings>) {
    let (rows, control) = read_of(wing, quantity);
    let read = operator.readings(case, &rows);
    let Some(control) = control else { return (read, None) };
    let mut deflected = case.clone();
    deflected.controls_rad = vec![0.0; wing.controls.len()];
    deflected.controls_rad[control] = 1.0_f64.to_radians();
    (operator.readings(&deflected, &rows), Some(read))
}

fn value_of(
    wing: &ElasticWing,
    operator: &SteadyOperator<'_>,
    case: &SteadyCase,
    quantity: &Quantity,
) -> f64 {
    let (read, less) = readings_of(wing, operator, case, quantity);
    read.values[0] - less.map_or(0.0, |less| less.values[0])
}

fn gradient_of(
    wing: &ElasticWing,
    operator: &SteadyOperator<'_>,
    case: &SteadyCase,
    quantity: &Quantity,
    modes: &Modes,
    prior: &CorrectionPrior,
) -> Vec<f64> {
    let (read, less) = readings_of(wing, operator, case, quantity);
    let mut gradient = modes.gradient(&read, 0, prior);
    if let Some(less) = less {
        gradient.iter_mut().zip(modes.gradient(&less, 0, prior)).for_each(|(a, b)| *a -= b);
    }
    gradient
}

/// What the data of one airspeed leave of the prior.
struct Posterior {
    /// Rows by unknowns, over the standard deviation of a row.
    rows: Vec<Vec<f64>>,
}

impl Posterior {
    fn new(
        wing: &ElasticWing,
        calibration: &Calibration,
        at: &AirspeedCalibration,
        prior: &CorrectionPrior,
        modes: &Modes,
    ) -> Result<Self, CouplingError> {
        let flow = Flow { v_m_s: at.data.v_m_s, rho_kg_m3: calibration.rho_kg_m3 };
        let corrected = wing.at(flow, &at.corrections)?;
        let data = &calibration.data;
        let sigma = data.point_sigma.unwrap_or(at.line.rmse);
        let mut rows: Vec<Vec<f64>> = Vec::new();
        let mut tip_rows = Vec::new();
        for angle in &at.data.angles {
            let read: Readings = corrected.readings(&SteadyCase::new(flow, angle.alpha_rad), &wing.root_rows);
            for channel in (0..4).filter(|&c| data.channels[c]) {
                let size =
                    (sigma[channel] / (angle.replicates as f64).sqrt()).hypot(data.block_sigma[channel]);
                let row = modes.gradient(&read, channel, prior);
                if channel == crate::campaign::TIP {
                    tip_rows.push(rows.len());
                }
                rows.push(row.iter().map(|value| value / size.max(f64::MIN_POSITIVE)).collect());
            }
        }
        if data.tip == crate::campaign::TipReading::FreeZero {
            centre(&mut rows, &tip_rows);
        }
        Ok(Self { rows })
    }

    fn prediction(&self, quantity: Quantity, [theory, value]: [f64; 2], gradient: &[f64]) -> Prediction {
        let prior_sigma = gradient.iter().map(|x| x * x).sum::<f64>().sqrt();
        Prediction { quantity, theory, value, prior_sigma, sigma: self.sigma_with(&[], gradient) }
    }

    /// Standard deviation of what has this gradient, with further rows beside the data:
    /// `g' g - (J g)' (J J' + I)⁻¹ (J g)`.
    fn sigma_with(&self, further: &[Vec<f64>], gradient: &[f64]) -> f64 {
        let rows: Vec<&Vec<f64>> = self.rows.iter().chain(further).collect();
        let product = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
        let covariance = Mat::from_fn(rows.len(), rows.len(), |i, j| {
            product(rows[i], rows[j]) + f64::from(u8::from(i == j))
        });
        let seen = Mat::from_fn(rows.len(), 1, |i, _| product(rows[i], gradient));
        let before = product(gradient, gradient);
        // a unit matrix and a square: always positive
        let Ok(factor) = covariance.llt(Side::Lower) else { return before.sqrt() };
        let solved = factor.solve(&seen);
        let told: f64 = (0..seen.nrows()).map(|r| seen[(r, 0)] * solved[(r, 0)]).sum();
        (before - told).max(0.0).sqrt()
    }
}

/// A zero that is not known takes the mean out of rows.
fn centre(rows: &mut [Vec<f64>], of: &[usize]) {
    let Some(&first) = of.first() else { return };
    for k in 0..rows[first].len() {
        let mean = of.iter().map(|&r| rows[r][k]).sum::<f64>() / of.len() as f64;
        for &r in of {
            rows[r][k] -= mean;
        }
    }
}
