//! What could be said of a wing by somebody who knows the generator: the linear regression of the truth on the measurements over other wings
//! that it drew, the best linear prediction with the generator's own means and covariances in the place of a prior.

use super::trust_judged::True;
use calibrate::{Campaign, TipReading};
use faer::linalg::solvers::Solve;
use faer::{Mat, Side};

/// Half of a 90 % interval over the standard deviation (Gaussian).
const HALF_90: f64 = 1.644_853_627;
/// Share of the measurements' variance that the regression is damped by: one may follow from others.
const DAMPING: f64 = 1e-9;

/// A regression on one set of sensors.
pub(super) struct Generator {
    /// Of each measurement.
    mean: Vec<f64>,
    sigma: Vec<f64>,
    /// Measurements by quantities, over their standard deviations.
    weights: Mat<f64>,
    mean_true: Vec<f64>,
    half_width: Vec<f64>,
}

impl Generator {
    /// From wings with all quantities, and what was measured of them. More wings than measurements are needed by far.
    pub(super) fn new(measured: &[Vec<f64>], truths: &[Vec<f64>]) -> Option<Self> {
        let (count, inputs, outputs) = (measured.len(), measured.first()?.len(), truths.first()?.len());
        let freedom = count.checked_sub(inputs + 1).filter(|freedom| *freedom > 0)? as f64;
        let means = |of: &[Vec<f64>], columns: usize| -> Vec<f64> {
            (0..columns).map(|c| of.iter().map(|row| row[c]).sum::<f64>() / count as f64).collect()
        };
        let (mean, mean_true) = (means(measured, inputs), means(truths, outputs));
        let sigma: Vec<f64> = (0..inputs)
            .map(|c| {
                (measured.iter().map(|row| (row[c] - mean[c]).powi(2)).sum::<f64>() / count as f64).sqrt()
            })
            .collect();
        let x =
            Mat::from_fn(count, inputs, |i, c| (measured[i][c] - mean[c]) / sigma[c].max(f64::MIN_POSITIVE));
        let y = Mat::from_fn(count, outputs, |i, q| truths[i][q] - mean_true[q]);
        let mut squares = x.transpose() * &x;
        (0..inputs).for_each(|c| squares[(c, c)] += DAMPING * count as f64);
        let weights = squares.llt(Side::Lower).ok()?.solve(x.transpose() * &y);
        let left = &y - &x * &weights;
        // the regression itself is known from so many wings only
        let more = 1.0 + (inputs as f64 + 1.0) / count as f64;
        let half_width = (0..outputs).map(|q| {
            HALF_90 * (more * (0..count).map(|i| left[(i, q)].powi(2)).sum::<f64>() / freedom).sqrt()
        });
        Some(Self { half_width: half_width.collect(), mean, sigma, weights, mean_true })
    }

    /// 90 % intervals of all quantities.
    pub(super) fn intervals(&self, measured: &[f64]) -> Vec<[f64; 2]> {
        let x = |c: usize| (measured[c] - self.mean[c]) / self.sigma[c].max(f64::MIN_POSITIVE);
        let one = |q: usize| {
            let value =
                self.mean_true[q] + (0..measured.len()).map(|c| self.weights[(c, q)] * x(c)).sum::<f64>();
            [value - self.half_width[q], value + self.half_width[q]]
        };
        (0..self.mean_true.len()).map(one).collect()
    }
}

/// Values of a wing that has all quantities it is asked for; `judged` says which those are.
pub(super) fn values(truths: &[Option<True>], judged: &[bool]) -> Option<Vec<f64>> {
    let one = |(truth, judged): (&Option<True>, &bool)| match truth {
        Some(truth) => Some(truth.value),
        None => (!judged).then_some(0.0),
    };
    truths.iter().zip(judged).map(one).collect()
}

/// What a campaign with the wind on says: mean and slope over the angle of each load and sensor, and by how much each deflected pair differs.
pub(super) fn measurements(campaign: &Campaign) -> Vec<f64> {
    let blown = || campaign.points.iter().filter(|point| point.v_m_s > 0.0);
    let with_tip = campaign.tip != TipReading::Unused;
    let readings = |point: &calibrate::StaticPoint| -> Vec<Option<f64>> {
        let tip = with_tip.then_some(point.tip_z_m);
        point.loads.into_iter().chain(tip).chain(point.sensors.iter().copied()).collect()
    };
    let neutral: Vec<(f64, Vec<Option<f64>>)> = blown()
        .filter(|point| point.controls_rad.is_empty())
        .map(|point| (point.alpha_rad, readings(point)))
        .collect();
    let columns = neutral.first().map_or(0, |(_, readings)| readings.len());
    let mut found = Vec::new();
    for column in 0..columns {
        let read: Vec<[f64; 2]> =
            neutral.iter().filter_map(|(alpha, readings)| Some([*alpha, readings[column]?])).collect();
        let mean = |i: usize| read.iter().map(|pair| pair[i]).sum::<f64>() / read.len() as f64;
        let (alpha, value) = (mean(0), mean(1));
        let across: f64 = read.iter().map(|pair| (pair[0] - alpha) * (pair[1] - value)).sum();
        let along: f64 = read.iter().map(|pair| (pair[0] - alpha).powi(2)).sum();
        found.extend([value, across / along]);
    }
    let deflected: Vec<Vec<Option<f64>>> =
        blown().filter(|point| !point.controls_rad.is_empty()).map(readings).collect();
    for pair in deflected.chunks_exact(2) {
        found.extend(pair[0].iter().zip(&pair[1]).filter_map(|(low, high)| Some((*high)? - (*low)?)));
    }
    found
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "a regression that cannot be made must fail")]

    use super::Generator;

    /// A truth of unit variance measured with noise of half of that: the posterior has the mean `m / 1.25` and the variance `0.25 / 1.25`.
    #[test]
    fn the_regression_is_the_posterior_of_a_gaussian_with_known_variances() {
        // even steps of the inverse normal would do; a sum of twelve uniform numbers is Gaussian enough for two per cent
        let mut state = 7_u64;
        let mut normal = || {
            let mut sum = -6.0;
            for _ in 0..12 {
                state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
                sum += (state >> 11) as f64 / (1_u64 << 53) as f64;
            }
            sum
        };
        let (mut measured, mut truths) = (Vec::new(), Vec::new());
        for _ in 0..20_000 {
            let truth = normal();
            truths.push(vec![3.0 + truth]);
            measured.push(vec![10.0 + truth + 0.5 * normal()]);
        }
        let generator = Generator::new(&measured, &truths).unwrap();
        let [low, high] = generator.intervals(&[11.0])[0];
        assert!((0.5 * (low + high) - (3.0 + 1.0 / 1.25)).abs() < 0.02, "{low} {high}");
        assert!((0.5 * (high - low) / (1.644_853_627 * 0.2_f64.sqrt()) - 1.0).abs() < 0.02, "{low} {high}");
    }
}
