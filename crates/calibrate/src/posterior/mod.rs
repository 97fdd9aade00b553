//! How far to trust what the corrected wing predicts: the distribution of corrections that the data leave, and the interval of
//! every prediction.
//!
//! With root loads alone the calibration's own corrections are the centre: the least change of pressures that reaches them. Where
//! more was measured, the mean of the posterior is.
//!
//! Corrections about theory, what controls do and the flexibility are Gaussian before the data ([`CorrectionPrior`]). Data
//! `d = h(z) + noise`, linearised where the squares of misses and unknowns are least, leave `z` with the covariance
//! `(I + J' N⁻¹ J)⁻¹` in units of the prior (Tarantola, Inverse Problem Theory, 2005, Section 3.2), and a prediction with
//! gradient `g` has the variance `g' C g`. Where more than root loads was measured, corrections of different airspeeds are alike and the
//! structure is the same, so that what was measured at one tells of the others; with root loads alone, whose centre is not the mean, each
//! airspeed stands for itself.

mod data;
mod joint;
mod known;
mod means;
pub mod next;
mod off;
pub mod predictions;
mod prior;
mod read;

pub use off::WingOff;
pub(crate) use prior::Unknowns;

use crate::HALF_90;
use crate::calibration::Calibration;
use aero::Corrections;
use coupling::wing_file::CorrectionPrior;
use coupling::{CouplingError, ElasticWing};
use faer::Mat;
use known::Known;
use predictions::{Predicted, Quantity, predict, quantities};

/// A prediction with its interval.
#[derive(Debug, Clone, PartialEq)]
pub struct Prediction {
    /// What is predicted.
    pub quantity: Quantity,
    /// By theory.
    pub theory: f64,
    /// By the wing that is known.
    pub value: f64,
    /// Standard deviation before the data, about the wing that is known.
    pub prior_sigma: f64,
    /// Standard deviation with the data.
    pub sigma: f64,
}

impl Prediction {
    /// The 90 % interval.
    pub fn interval(&self) -> [f64; 2] {
        [self.value - HALF_90 * self.sigma, self.value + HALF_90 * self.sigma]
    }

    /// The 90 % interval before the data, about the wing that is known.
    pub fn interval_before(&self) -> [f64; 2] {
        [self.value - HALF_90 * self.prior_sigma, self.value + HALF_90 * self.prior_sigma]
    }

    /// Share of the prior's variance that the data took away.
    pub fn decided(&self) -> f64 {
        1.0 - (self.sigma / self.prior_sigma.max(f64::MIN_POSITIVE)).powi(2)
    }
}

/// What is known at one airspeed.
#[derive(Debug, Clone, PartialEq)]
pub struct AirspeedPosterior {
    /// Airspeed, m/s.
    pub v_m_s: f64,
    /// Angle of attack of all predictions, the largest that was measured, rad.
    pub alpha_rad: f64,
    /// The mean, where more than root loads was measured; without it the wing is that of the calibration.
    pub mean: Option<WingOff>,
    /// Corrections next to the mean with which the wing has the measured root loads, its structure as given.
    pub corrections: Corrections,
    /// Columns that are off the wing that is known by more than noise, and how many times it; it was taken as noise.
    pub beyond: Vec<(String, f64)>,
    /// By quantity.
    pub predictions: Vec<Prediction>,
    /// How far the wing may be off.
    pub(crate) spread: Spread,
}

/// How far the unknowns of a wing may be off, and what that does to predictions.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Spread {
    /// Symmetric root of the unknowns' covariance, in units of the prior.
    pub(crate) root: Mat<f64>,
    /// Derivatives of each prediction by the unknowns.
    pub(crate) gradients: Vec<Vec<f64>>,
    /// The same of sections and the tip at the least angle that was measured: with those at the largest they are what any load
    /// factor's loads and shape are made of.
    pub(crate) at_least: Vec<Vec<f64>>,
}

/// What is known at every calibrated airspeed.
///
/// # Errors
/// If the wing cannot be solved, or a row deflects a control that it has not.
pub fn posterior(
    wing: &ElasticWing,
    calibration: &Calibration,
    prior: &CorrectionPrior,
) -> Result<Vec<AirspeedPosterior>, CouplingError> {
    let listed = quantities(wing);
    let of_the_whole_wing: Vec<Quantity> =
        listed.iter().filter(|quantity| quantity.is_of_the_whole_wing()).cloned().collect();
    let (known, joint) = Known::all(wing, calibration, prior)?;
    let of = |(k, known): (usize, Known<'_>)| {
        let theory = WingOff::theory(wing);
        let uncorrected = wing.at(known.flow, &theory.corrections)?;
        let case = known.largest();
        let by_theory = predict(wing, &uncorrected, &theory, &case, &listed)?;
        let predicted = predict(wing, &known.corrected, &known.off, &case, &listed)?;
        let gradients_of = |predicted: &[Predicted]| -> Vec<Vec<f64>> {
            predicted.iter().map(|at| at.gradient(&known.unknowns)).collect()
        };
        let gradients = gradients_of(&predicted);
        let at_least = predict(wing, &known.corrected, &known.off, &known.least(), &of_the_whole_wing)?;
        let each = listed.iter().zip(by_theory).zip(predicted.iter().zip(&gradients));
        let predictions = each.map(|((quantity, theory), (at, gradient))| {
            let sensors = &calibration.data.sensors;
            let reading = known.reading_of(quantity, sensors);
            let by_all = known.with_reading(gradient.clone(), reading, at.value());
            Prediction {
                quantity: quantity.clone(),
                theory: theory.value(),
                value: at.value(),
                prior_sigma: by_all.iter().map(|x| x * x).sum::<f64>().sqrt(),
                sigma: joint.sigma(k, &by_all),
            }
        });
        let predictions = predictions.collect();
        Ok(AirspeedPosterior {
            spread: Spread { root: joint.root(k), gradients, at_least: gradients_of(&at_least) },
            v_m_s: known.flow.v_m_s,
            alpha_rad: case.alpha_rad,
            mean: known.is_mean.then_some(known.off),
            corrections: known.given,
            beyond: known.beyond,
            predictions,
        })
    };
    known.into_iter().enumerate().map(of).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use coupling::{SteadyCase, SteadyModel};

    #[test]
    fn an_interval_is_1645_standard_deviations_on_both_sides() {
        let one = Prediction {
            quantity: Quantity::TipHeight,
            theory: 9.0,
            value: 2.0,
            prior_sigma: 1.0,
            sigma: 0.1,
        };
        let half = 1.644_853_627;
        let near = |found: [f64; 2], low: f64, high: f64| {
            assert!((found[0] - low).abs() < 1e-12 && (found[1] - high).abs() < 1e-12, "{found:?}");
        };
        near(one.interval(), 2.0 - 0.1 * half, 2.0 + 0.1 * half);
        near(one.interval_before(), 2.0 - half, 2.0 + half);
        assert!((one.decided() - 0.99).abs() < 1e-12);
        let half_as_wide = Prediction { prior_sigma: 4.0, sigma: 2.0, ..one };
        assert!((half_as_wide.decided() - 0.75).abs() < 1e-12);
    }
    /// Readings of the shipped wing itself, so that its posterior is linearised at theory: what the ensemble is told of the least angle
    /// is how the wing reads there when a part of its lift changes.
    #[test]
    fn at_the_least_angle_derivatives_are_those_of_differences() {
        let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/tuflex/wing_beam.ron");
        let (_, wing) = coupling::ElasticWing::read(&path).expect("a wing that is shipped");
        let neutral = Corrections::neutral(wing.correctable.len());
        let flow = aero::Flow { v_m_s: 26.0, rho_kg_m3: crate::tests::RHO };
        let case = |alpha_rad: f64| SteadyCase::new(flow, alpha_rad);
        let alphas_rad = [0.02, -0.07, 0.06, -0.03, 0.1];
        let loads = wing.root_loads(&alphas_rad.map(case), &neutral).expect("it does not diverge");
        let points = alphas_rad.iter().zip(loads).enumerate().map(|(i, (alpha_rad, load))| {
            let [fz, mx, my] = load.to_array();
            crate::tests::point(i + 2, flow.v_m_s, *alpha_rad, [fz, mx, my, 0.0])
        });
        let campaign = crate::tests::campaign(points.collect(), Some([0.05, 0.03, 0.02, 0.001]));
        let found = crate::calibrate(&wing, &campaign, &crate::tests::settings(2)).expect("sound data");
        let prior = CorrectionPrior::default();
        let known = posterior(&wing, &found, &prior).expect("one airspeed");
        let unknowns = Unknowns::new(&wing, &prior);
        let by_tip = known[0].spread.at_least.last().expect("the tip is the last");
        for unknown in [3, 40] {
            let tip_m = |step: f64| {
                let mut z = vec![0.0; unknowns.count()];
                z[unknown] = step;
                wing.tip_deflections(&[case(-0.07)], &unknowns.wing(&z).corrections).expect("a tip")[0]
            };
            let by = (tip_m(1e-3) - tip_m(-1e-3)) / 2e-3;
            assert!((by_tip[unknown] / by - 1.0).abs() < 1e-5, "{unknown}: {} {by}", by_tip[unknown]);
        }
    }
}
