//! How far to trust what the corrected wing predicts: the distribution of corrections that the data leave, and the interval of
//! every prediction.
//!
//! Corrections about theory are Gaussian before the data ([`prior`]). Linearised at the calibrated corrections, data
//! `d = J z + noise` leave `z` with the covariance `(I + J' N⁻¹ J)⁻¹` in units of the prior (Tarantola, Inverse Problem Theory,
//! 2005, Section 3.2), and a prediction with gradient `g` has the variance `g' C g`. Its centre is the calibrated wing.

pub mod predictions;
pub mod prior;

use crate::calibration::{AirspeedCalibration, Calibration};
use aero::{Corrections, Flow};
use coupling::{CouplingError, ElasticWing, Readings, SteadyCase};
use faer::linalg::solvers::Solve;
use faer::{Mat, Side};
use predictions::{Quantity, quantities};
use prior::{Modes, Prior};

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
    prior: &Prior,
) -> Result<Vec<AirspeedPredictions>, CouplingError> {
    let modes = Modes::new(wing, prior);
    calibration.airspeeds.iter().map(|at| at_airspeed(wing, calibration, at, prior, &modes)).collect()
}

fn at_airspeed(
    wing: &ElasticWing,
    calibration: &Calibration,
    at: &AirspeedCalibration,
    prior: &Prior,
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
    for (c, control) in wing.control_names().into_iter().enumerate() {
        let mut deflected = case.clone();
        deflected.controls_rad = vec![0.0; wing.controls.len()];
        deflected.controls_rad[c] = 1.0_f64.to_radians();
        let moment = Mat::from_fn(1, wing.root_rows.ncols(), |_, k| wing.root_rows[(1, k)]);
        let of = |operator: &coupling::SteadyOperator<'_>| {
            [&case, &deflected].map(|case| operator.readings(case, &moment))
        };
        let [from, to] = of(&corrected);
        let [from_theory, to_theory] = of(&theory);
        let gradient: Vec<f64> = modes
            .gradient(&to, 0, prior)
            .iter()
            .zip(modes.gradient(&from, 0, prior))
            .map(|(to, from)| to - from)
            .collect();
        let values = [to_theory.values[0] - from_theory.values[0], to.values[0] - from.values[0]];
        predictions.push(posterior.prediction(Quantity::ControlMx { control }, values, &gradient));
    }
    Ok(AirspeedPredictions { v_m_s: flow.v_m_s, alpha_rad, predictions })
}

/// What the data of one airspeed leave of the prior.
struct Posterior {
    /// Rows by unknowns, over the standard deviation of a row.
    whitened: Mat<f64>,
    /// `J J' + I`, factorised.
    factor: faer::linalg::solvers::Llt<f64>,
}

impl Posterior {
    fn new(
        wing: &ElasticWing,
        calibration: &Calibration,
        at: &AirspeedCalibration,
        prior: &Prior,
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
        let whitened = Mat::from_fn(rows.len(), modes.size(), |r, k| rows[r][k]);
        let square = &whitened * whitened.transpose();
        let covariance =
            Mat::from_fn(rows.len(), rows.len(), |i, j| square[(i, j)] + f64::from(u8::from(i == j)));
        let factor = covariance
            .llt(Side::Lower)
            .map_err(|_| nastran::InputError::general("the covariance of the data is not positive"))?;
        Ok(Self { whitened, factor })
    }

    fn prediction(&self, quantity: Quantity, [theory, value]: [f64; 2], gradient: &[f64]) -> Prediction {
        let g = Mat::from_fn(gradient.len(), 1, |k, _| gradient[k]);
        let before: f64 = gradient.iter().map(|x| x * x).sum();
        let seen = &self.whitened * &g;
        let solved = self.factor.solve(&seen);
        let told: f64 = (0..seen.nrows()).map(|r| seen[(r, 0)] * solved[(r, 0)]).sum();
        Prediction {
            quantity,
            theory,
            value,
            prior_sigma: before.sqrt(),
            sigma: (before - told).max(0.0).sqrt(),
        }
    }
}

/// A zero that is not known takes the mean out of rows.
fn centre(rows: &mut [Vec<f64>], of: &[usize]) {
    let Some(&first) = of.first() else { return };
    for k in 0..rows[first].len() {
        let mean = of.iter().map(|&r| rows[r][k]).sum::<f64>() / of.len() as f64;
        of.iter().for_each(|&r| rows[r][k] -= mean);
    }
}
