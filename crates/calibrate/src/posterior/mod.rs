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
use crate::campaign::{TIP, TipReading};
use aero::{Corrections, Flow};
use coupling::wing_file::CorrectionPrior;
use coupling::{CouplingError, ElasticWing, Readings, SteadyCase, SteadyOperator};
use faer::linalg::solvers::Solve;
use faer::{Mat, Side};
use nastran::InputError;
use predictions::{Quantity, quantities, row_of};
use prior::Modes;
use std::rc::Rc;

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

    /// The 90 % interval before the data, about the calibrated wing.
    pub fn interval_before(&self) -> [f64; 2] {
        [self.value - HALF_90 * self.prior_sigma, self.value + HALF_90 * self.prior_sigma]
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
    let listed = quantities(wing);
    let of = |at: &AirspeedCalibration| {
        let known = Known::new(wing, calibration, at, prior)?;
        let theory = wing.at(known.flow, &Corrections::neutral(wing.correctable.len()))?;
        let case = known.largest();
        let by_theory = read(wing, &theory, &case, &listed)?;
        let predicted = read(wing, &known.corrected, &case, &listed)?;
        let predictions = listed.iter().zip(by_theory).zip(predicted).map(|((quantity, theory), at)| {
            let gradient = known.gradient(&at);
            Prediction {
                quantity: quantity.clone(),
                theory: theory.value(),
                value: at.value(),
                prior_sigma: gradient.iter().map(|x| x * x).sum::<f64>().sqrt(),
                sigma: known.sigma_with(&[], &gradient),
            }
        });
        let predictions = predictions.collect();
        Ok(AirspeedPredictions { v_m_s: known.flow.v_m_s, alpha_rad: case.alpha_rad, predictions })
    };
    calibration.airspeeds.iter().map(of).collect()
}

/// A reading: a row of readings, less that of another case.
struct Read {
    of: Rc<Readings>,
    less: Option<Rc<Readings>>,
    row: usize,
}

impl Read {
    fn value(&self) -> f64 {
        self.of.values[self.row] - self.less.as_ref().map_or(0.0, |less| less.values[self.row])
    }
}

/// Reads quantities in a case; what a control does is the case with it by a degree less the case without it.
fn read(
    wing: &ElasticWing,
    operator: &SteadyOperator<'_>,
    case: &SteadyCase,
    quantities: &[Quantity],
) -> Result<Vec<Read>, InputError> {
    let loads = quantities.iter().filter(|quantity| **quantity != Quantity::TipHeight);
    let rows: Vec<Vec<f64>> = loads.map(|quantity| row_of(wing, quantity)).collect();
    let matrix = Mat::from_fn(rows.len(), wing.root_rows.ncols(), |r, k| rows[r][k]);
    let held = Rc::new(operator.readings(case, &matrix));
    let names = wing.control_names();
    let mut next_row = 0..;
    let one = |quantity: &Quantity| {
        if *quantity == Quantity::TipHeight {
            return Ok(Read { of: Rc::clone(&held), less: None, row: rows.len() });
        }
        let row = next_row.next().unwrap_or_default();
        let Quantity::ControlMx { control } = quantity else {
            return Ok(Read { of: Rc::clone(&held), less: None, row });
        };
        let Some(index) = names.iter().position(|name| name == control) else {
            return Err(InputError::general(format!("the wing has no control surface {control}")));
        };
        let mut deflected = case.clone();
        deflected.controls_rad = vec![0.0; names.len()];
        deflected.controls_rad[index] = 1.0_f64.to_radians();
        Ok(Read { of: Rc::new(operator.readings(&deflected, &matrix)), less: Some(Rc::clone(&held)), row })
    };
    quantities.iter().map(one).collect()
}

/// What is known of the corrections of one airspeed.
struct Known<'a> {
    flow: Flow,
    alphas_rad: Vec<f64>,
    /// The calibrated wing.
    corrected: SteadyOperator<'a>,
    modes: Modes,
    /// Standard deviation of one row of the static cases, by channel.
    sigma: [f64; 4],
    /// Rows of the data by unknowns, over their standard deviation.
    rows: Vec<Vec<f64>>,
}

impl<'a> Known<'a> {
    fn new(
        wing: &'a ElasticWing,
        calibration: &Calibration,
        at: &AirspeedCalibration,
        prior: &CorrectionPrior,
    ) -> Result<Self, CouplingError> {
        let data = &calibration.data;
        let flow = Flow { v_m_s: at.data.v_m_s, rho_kg_m3: calibration.rho_kg_m3 };
        let mut known = Self {
            flow,
            alphas_rad: at.data.angles.iter().map(|angle| angle.alpha_rad).collect(),
            corrected: wing.at(flow, &at.corrections)?,
            modes: Modes::new(wing, prior),
            sigma: data.point_sigma.unwrap_or(at.line.rmse),
            rows: Vec::new(),
        };
        let readings: Vec<Readings> = known
            .alphas_rad
            .iter()
            .map(|&alpha| known.corrected.readings(&known.case(alpha), &wing.root_rows))
            .collect();
        let common = data.common_sigma();
        for channel in (0..4).filter(|&c| data.channels[c]) {
            let mut rows: Vec<Vec<f64>> =
                readings.iter().map(|read| known.modes.gradient(read, channel)).collect();
            if channel == TIP && data.tip == TipReading::FreeZero {
                take_out_mean(&mut rows);
            }
            for (row, angle) in rows.iter_mut().zip(&at.data.angles) {
                // behind the wing's unknowns: the offset common to all blocks, which moves a channel's rows together
                row.extend((0..4).map(|c| if c == channel { common[c] } else { 0.0 }));
                let sigma = known.sigma[channel] / (angle.replicates as f64).sqrt();
                *row = over(std::mem::take(row), sigma);
            }
            known.rows.extend(rows);
        }
        Ok(known)
    }

    fn case(&self, alpha_rad: f64) -> SteadyCase {
        SteadyCase::new(self.flow, alpha_rad)
    }

    /// The case with the largest angle that was measured.
    fn largest(&self) -> SteadyCase {
        self.case(self.alphas_rad.iter().copied().fold(f64::NEG_INFINITY, f64::max))
    }

    fn gradient(&self, read: &Read) -> Vec<f64> {
        let mut gradient = self.modes.gradient(&read.of, read.row);
        if let Some(less) = &read.less {
            for (value, less) in gradient.iter_mut().zip(self.modes.gradient(less, read.row)) {
                *value -= less;
            }
        }
        gradient
    }

    /// Standard deviation of what has this gradient, with further rows beside the data:
    /// `g' g - (J g)' (J J' + I)⁻¹ (J g)`. Unknowns that a row or the gradient does not list have no part in it.
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

/// A row over the standard deviation of its reading.
fn over(row: Vec<f64>, sigma: f64) -> Vec<f64> {
    row.into_iter().map(|value| value / sigma.max(f64::MIN_POSITIVE)).collect()
}

/// A zero that is not known takes the mean out of rows.
fn take_out_mean(rows: &mut [Vec<f64>]) {
    let count = rows.len() as f64;
    for k in 0..rows.first().map_or(0, Vec::len) {
        let mean = rows.iter().map(|row| row[k]).sum::<f64>() / count;
        for row in rows.iter_mut() {
            row[k] -= mean;
        }
    }
}
