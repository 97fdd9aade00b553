//! How well a hidden effect can be seen: the squared distance between the training data with and without it.
//!
//! `d2 = dᵀ (N + T + J Jᵀ)⁻¹ d` with d the difference of the noise-free loads of one replicate's length, N the noise of
//! the mean of all replicates, T the run tolerance (1 % of the mean, 3 % of what varies, 4 ms, an offset) and J what each nuisance
//! changes by one standard deviation: what true wings are off by, and what the wing's file leaves open. So a difference that the
//! tolerances or the nuisances explain hardly counts: a servo one of the file's standard deviations off has a d2 of a few.

use crate::at_speed::AtSpeed;
use crate::campaign::BLOCKS;
use crate::decimate::decimated;
use crate::design::{RHO_KG_M3, SAMPLE_RATE_HZ, STATIC_ANGLES_DEG, runs};
use crate::noise;
use crate::simulate::{Commands, TrueWing};
use faer::Mat;
use faer::linalg::solvers::Solve;

/// Tolerances of a run.
const MEAN_SHARE: f64 = 0.01;
const VARYING_SHARE: f64 = 0.03;
const SHIFT_S: f64 = 0.004;

/// Loads of the training data, piece by piece: every run's channels, then the static points of every airspeed and channel.
pub(crate) type Loads = Vec<Vec<f64>>;

/// Airspeeds that the training data have.
pub(crate) const TRAIN_M_S: [f64; 3] = [18.0, 30.0, 34.0];

/// Noise-free loads of the training data (records of the first block, `start_s` zero).
pub(crate) fn clean(wing: &TrueWing<'_>, controls: &[String]) -> Loads {
    let speeds: Vec<AtSpeed> = TRAIN_M_S.iter().map(|v_m_s| wing.at(*v_m_s)).collect();
    let mut pieces = Vec::new();
    for (number, planned) in runs(controls).iter().enumerate().filter(|(_, planned)| planned.train) {
        let Some(at) = speeds.iter().find(|at| at.v_m_s == planned.v_m_s) else { continue };
        let commands = Commands::of(planned, controls.len());
        let mut flown = wing.fly(at, &commands);
        // the order of the runs is random: the design's stands for it
        let start_s = crate::design::CYCLE_S * ((number * 29) % 37) as f64;
        wing.measure(&TrueWing::here(at, &commands, (start_s, number as u64)), &mut flown);
        pieces.extend(flown.loads.iter().map(|load| decimated(load)));
    }
    for at in &speeds {
        let points = STATIC_ANGLES_DEG.iter().map(|alpha_deg| {
            let commands = Commands::steady(alpha_deg.to_radians(), controls.len());
            let mut flown = wing.fly(at, &commands);
            wing.measure(&TrueWing::here(at, &commands, (0.0, u64::MAX)), &mut flown);
            [0, 1, 2].map(|channel| flown.loads[channel][0])
        });
        let points: Vec<[f64; 3]> = points.collect();
        pieces.extend((0..3).map(|channel| points.iter().map(|loads| loads[channel]).collect()));
    }
    pieces
}

/// Noise and tolerances of one piece.
#[derive(Debug, Clone)]
struct Piece {
    /// Variance of a value.
    variance: f64,
    /// Directions with standard deviation one.
    tolerances: Mat<f64>,
    /// `(I + Tᵀ N⁻¹ T)⁻¹`
    inner: Mat<f64>,
}

impl Piece {
    fn new(values: &[f64], variance: f64, offset: f64, static_points: bool) -> Self {
        let mean = values.iter().sum::<f64>() / values.len().max(1) as f64;
        let last = values.len().saturating_sub(1);
        let rate = |i: usize| {
            let (before, after) = (values[i.saturating_sub(1)], values[(i + 1).min(last)]);
            0.5 * (after - before) * SAMPLE_RATE_HZ as f64
        };
        let count = if static_points { 2 } else { 4 };
        let tolerances = Mat::from_fn(values.len(), count, |i, direction| match (direction, static_points) {
            (0, _) => offset,
            (1, true) => MEAN_SHARE * values[i],
            (1, false) => MEAN_SHARE * mean,
            (2, _) => VARYING_SHARE * (values[i] - mean),
            _ => SHIFT_S * rate(i),
        });
        let gram = tolerances.transpose() * &tolerances;
        let inner = Mat::from_fn(count, count, |i, j| f64::from(u8::from(i == j)) + gram[(i, j)] / variance);
        let inner = inner.partial_piv_lu().solve(Mat::<f64>::identity(count, count));
        Self { variance, tolerances, inner }
    }

    /// `(N + T Tᵀ)⁻¹ d`
    fn weighted(&self, difference: &[f64]) -> Vec<f64> {
        let count = self.tolerances.ncols();
        let along: Vec<f64> = (0..count)
            .map(|k| (0..difference.len()).map(|i| self.tolerances[(i, k)] * difference[i]).sum::<f64>())
            .collect();
        let share: Vec<f64> = (0..count)
            .map(|k| (0..count).map(|l| self.inner[(k, l)] * along[l]).sum::<f64>() / self.variance)
            .collect();
        let explained = |i: usize| (0..count).map(|k| self.tolerances[(i, k)] * share[k]).sum::<f64>();
        (0..difference.len()).map(|i| (difference[i] - explained(i)) / self.variance).collect()
    }
}

/// See the module.
#[derive(Debug)]
pub(crate) struct Metric {
    pieces: Vec<Piece>,
    /// J, and `(N + T Tᵀ)⁻¹ J`, by direction and piece.
    weighted: Vec<Loads>,
    /// `(I + Jᵀ (N + T Tᵀ)⁻¹ J)⁻¹`
    inner: Mat<f64>,
}

fn difference(a: &[f64], b: &[f64]) -> Vec<f64> {
    a.iter().zip(b).map(|(a, b)| a - b).collect()
}

fn product(a: &Loads, b: &Loads) -> f64 {
    a.iter().zip(b).map(|(a, b)| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>()).sum()
}

impl Metric {
    /// From the loads of the wing in the middle, and with every nuisance one standard deviation off.
    pub(crate) fn new(middle: &Loads, off: &[Loads], controls: &[String]) -> Self {
        let planned = runs(controls);
        let speeds: Vec<f64> = planned.iter().filter(|run| run.train).map(|run| run.v_m_s).collect();
        let piece = |(number, values): (usize, &Vec<f64>)| {
            let channel = number % 3;
            let replicates = BLOCKS as f64;
            let Some(v_m_s) = speeds.get(number / 3) else {
                let variance = noise::STATIC_POINT[channel].powi(2) / replicates;
                return Piece::new(values, variance, noise::BLOCK[channel] / replicates.sqrt(), true);
            };
            let buffet = noise::buffet_sigma(channel, 0.5 * RHO_KG_M3 * v_m_s * v_m_s);
            let white = noise::SAMPLE[channel].powi(2) + buffet.powi(2) * noise::correlated_samples();
            let offset = noise::BLOCK[channel].hypot(noise::RECORD[channel]) / replicates.sqrt();
            Piece::new(values, white / replicates, offset, false)
        };
        let pieces: Vec<Piece> = middle.iter().enumerate().map(piece).collect();
        let direction = |loads: &Loads| -> Loads {
            loads.iter().zip(middle).map(|(with, without)| difference(with, without)).collect()
        };
        let directions: Vec<Loads> = off.iter().map(direction).collect();
        let weigh = |loads: &Loads| -> Loads {
            pieces.iter().zip(loads).map(|(piece, values)| piece.weighted(values)).collect()
        };
        let weighted: Vec<Loads> = directions.iter().map(weigh).collect();
        let count = directions.len();
        let information = Mat::from_fn(count, count, |i, j| {
            f64::from(u8::from(i == j)) + product(&directions[i], &weighted[j])
        });
        let inner = information.partial_piv_lu().solve(Mat::<f64>::identity(count, count));
        Self { pieces, weighted, inner }
    }

    /// The squared distance between two sets of loads.
    pub(crate) fn d2(&self, with: &Loads, without: &Loads) -> f64 {
        let d: Loads = with.iter().zip(without).map(|(with, without)| difference(with, without)).collect();
        let whole: f64 = self
            .pieces
            .iter()
            .zip(&d)
            .map(|(piece, d)| piece.weighted(d).iter().zip(d).map(|(w, d)| w * d).sum::<f64>())
            .sum();
        let along: Vec<f64> = self.weighted.iter().map(|weighted| product(weighted, &d)).collect();
        let explained: f64 = (0..along.len())
            .map(|i| (0..along.len()).map(|j| along[i] * self.inner[(i, j)] * along[j]).sum::<f64>())
            .sum();
        (whole - explained).max(0.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_a_tolerance_explains_hardly_counts() {
        let values: Vec<f64> = (0..400).map(|i| 5.0 + (f64::from(i) * 0.1).sin()).collect();
        let piece = Piece::new(&values, 0.01, 0.05, false);
        let d2 = |d: &[f64]| piece.weighted(d).iter().zip(d).map(|(w, d)| w * d).sum::<f64>();
        // 3 % more of what varies: one standard deviation of a tolerance, so less than one
        let gain: Vec<f64> = values.iter().map(|value| VARYING_SHARE * (value - 5.0)).collect();
        assert!(d2(&gain) < 1.0);
        // as much of another shape: its own squares over the variance
        let other: Vec<f64> =
            (0..400).map(|i| if i % 2 == 0 { VARYING_SHARE } else { -VARYING_SHARE }).collect();
        let plain = 400.0 * VARYING_SHARE.powi(2) / 0.01;
        assert!((d2(&other) / plain - 1.0).abs() < 0.02);
    }
}
