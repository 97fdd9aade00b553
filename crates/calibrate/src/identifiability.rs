//! What the data can tell: singular values, determined directions, leverage of each family, posterior spread.
//!
//! Corrections are measured in pressure (the metric M of the minimum change), data in standard deviations of the
//! means. The prior is N(theory, s² M⁻¹) with s such that a family's corrections have a root mean square of
//! `prior_spread` over the boxes; with whitened Jacobian J the posterior precision is `M / s² + J' J`. Without known noise, the straight line's own error stands for it.

use crate::basis::{Basis, FAMILIES};
use crate::campaign::TIP;
use crate::fit::Linearised;
use crate::statics::Angle;
use crate::tip_zero::TipZero;
use faer::linalg::solvers::Solve;
use faer::{Mat, Side};
use schemars::JsonSchema;
use serde::Serialize;

/// One value for each family of corrections.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
pub struct ByFamily<T> {
    /// Factors of forces.
    pub force: T,
    /// Factors of moments.
    pub moment: T,
    /// Pressure offsets.
    pub pressure_offset: T,
}

impl<T> ByFamily<T> {
    /// From the order of the families: force, moment, pressure offset.
    pub fn from_array([force, moment, pressure_offset]: [T; 3]) -> Self {
        Self { force, moment, pressure_offset }
    }

    /// Another value from each.
    pub fn map<U>(self, of: impl FnMut(T) -> U) -> ByFamily<U> {
        ByFamily::from_array([self.force, self.moment, self.pressure_offset].map(of))
    }
}

/// What one airspeed's data say about its corrections.
#[derive(Debug, Clone, PartialEq)]
pub struct Identifiability {
    /// Singular values of the whitened Jacobian in units of the prior: how many times better than the prior each
    /// direction is known. Descending, at most channels times angles.
    pub singular_values: Vec<f64>,
    /// How many of them the data know better than the prior.
    pub determined_directions: usize,
    /// By family and channel: how strongly the channel hangs on the family, as a share of how strongly it hangs on
    /// all (roots of sums of squares of the sensitivities).
    pub leverage: ByFamily<[f64; 4]>,
    /// By family: standard deviation of the corrections after over before the data, mean over boxes. Near one: the
    /// data say nothing about it.
    pub remaining_spread: ByFamily<f64>,
    /// By family: posterior standard deviation of the corrections, root mean square over boxes.
    pub posterior_sigma: ByFamily<f64>,
    /// Standard deviation of the area-weighted mean of the force factor, before the data (the prior's) and after.
    pub mean_force_sigma: [f64; 2],
    /// Posterior standard deviation of the predicted reading by channel, root mean square over the angles, the offset
    /// common to all blocks included.
    pub predicted_sigma: [f64; 4],
}

impl Identifiability {
    /// Families that no channel hangs on (less than a twentieth of what it hangs on all): whatever the fit gives
    /// them is the prior's.
    pub fn undetermined(&self) -> Vec<&'static str> {
        let ByFamily { force, moment, pressure_offset } = &self.leverage;
        let families = FAMILIES.into_iter().zip([force, moment, pressure_offset]);
        families
            .filter(|(_, shares)| shares.iter().all(|share| *share < 0.05))
            .map(|(name, _)| name)
            .collect()
    }
}

/// What the analysis needs beside the linearisation.
pub(crate) struct Inputs<'a> {
    pub(crate) basis: &'a Basis,
    /// Area share of each box.
    pub(crate) area_share: &'a [f64],
    pub(crate) metric: &'a Mat<f64>,
    pub(crate) prior_spread: f64,
    pub(crate) channels: [bool; 4],
    /// All rows in the order of the sensitivities.
    pub(crate) angles: Vec<&'a Angle>,
    /// Rows that share a zero of the tip.
    pub(crate) zero: &'a TipZero,
    /// Standard deviation of one row by channel.
    pub(crate) point_sigma: [f64; 4],
    /// Spread of the offset common to all blocks, by channel.
    pub(crate) common_sigma: [f64; 4],
}

/// Analyses one airspeed at its solution; none if the metric is singular (a strip without boxes).
pub(crate) fn identifiability(at: &Linearised, inputs: &Inputs<'_>) -> Option<Identifiability> {
    let size = inputs.basis.size();
    // Each family's mean square over the boxes is the sum over its unknowns.
    let prior_spread = inputs.prior_spread / (size as f64 / FAMILIES.len() as f64).sqrt();
    let measured: Vec<usize> = (0..4).filter(|&c| inputs.channels[c]).collect();
    let gradients: Vec<Mat<f64>> = at.sensitivities.iter().map(|s| inputs.basis.gradient(s)).collect();
    let rows: Vec<(usize, usize)> =
        measured.iter().flat_map(|&c| (0..inputs.angles.len()).map(move |i| (c, i))).collect();
    let mut raw = Mat::from_fn(rows.len(), size, |r, k| gradients[rows[r].1][(rows[r].0, k)]);
    centre_tip(&mut raw, &rows, inputs);
    let factor = inputs.metric.llt(Side::Lower).ok()?;
    // J L^-T prior: unknowns in units of their prior spread
    let transposed = Mat::from_fn(size, rows.len(), |k, r| raw[(r, k)]);
    let scaled = lower_solve(factor.L(), &transposed);
    let sigma = |(c, i): (usize, usize)| {
        (inputs.point_sigma[c] / (inputs.angles[i].replicates as f64).sqrt()).max(f64::MIN_POSITIVE)
    };
    let whitened = Mat::from_fn(rows.len(), size, |r, k| scaled[(k, r)] * prior_spread / sigma(rows[r]));
    let svd = whitened.thin_svd().ok()?;
    let singular_values: Vec<f64> = (0..svd.S().dim()).map(|i| svd.S()[i]).collect();
    let noise = noise_covariance(&rows, inputs, sigma);
    let posterior = Posterior::new(&scaled, prior_spread, &noise)?;
    let by_box = posterior.by_box(inputs.basis, factor.L());
    Some(Identifiability {
        determined_directions: singular_values.iter().filter(|&&s| s > 1.0).count(),
        singular_values,
        leverage: ByFamily::from_array(leverage(&scaled, &rows, inputs)),
        remaining_spread: ByFamily::from_array(by_box.0),
        posterior_sigma: ByFamily::from_array(by_box.1),
        mean_force_sigma: posterior.mean_force(inputs, factor.L()),
        predicted_sigma: posterior.predicted(&rows),
    })
}

/// The zero of the tip is not known: only what rows say about their block's mean counts.
fn centre_tip(raw: &mut Mat<f64>, rows: &[(usize, usize)], inputs: &Inputs<'_>) {
    let Some(first) = rows.iter().position(|row| row.0 == TIP) else { return };
    for k in 0..raw.ncols() {
        inputs.zero.centre(&mut raw.col_as_slice_mut(k)[first..first + inputs.angles.len()]);
    }
}

/// Noise of the means, and the offset common to all blocks: it moves all angles of a channel together.
fn noise_covariance(
    rows: &[(usize, usize)],
    inputs: &Inputs<'_>,
    sigma: impl Fn((usize, usize)) -> f64,
) -> Mat<f64> {
    Mat::from_fn(rows.len(), rows.len(), |a, b| {
        let common = if rows[a].0 == rows[b].0 { inputs.common_sigma[rows[a].0].powi(2) } else { 0.0 };
        common + if a == b { sigma(rows[a]).powi(2) } else { 0.0 }
    })
}

/// Gaussian posterior in prior units: z ~ N(0, I), loads = A z + noise.
struct Posterior {
    /// unknowns by rows: prior_spread L⁻¹ J'
    load_of_unit: Mat<f64>,
    /// (A A' + N)⁻¹ A, rows by unknowns
    gain: Mat<f64>,
    prior_spread: f64,
}

impl Posterior {
    fn new(scaled: &Mat<f64>, prior_spread: f64, noise: &Mat<f64>) -> Option<Self> {
        let load_of_unit = Mat::from_fn(scaled.nrows(), scaled.ncols(), |k, r| scaled[(k, r)] * prior_spread);
        let covariance = load_of_unit.transpose() * &load_of_unit + noise;
        let gain = covariance.llt(Side::Lower).ok()?.solve(load_of_unit.transpose().to_owned());
        Some(Self { load_of_unit, gain, prior_spread })
    }

    /// Per family: mean ratio of posterior to prior spread of the boxes' corrections, and rms posterior spread.
    fn by_box(&self, basis: &Basis, metric_factor: faer::MatRef<'_, f64>) -> ([f64; 3], [f64; 3]) {
        let (mut ratio, mut sigma) = ([0.0; 3], [0.0; 3]);
        let boxes = basis.strip_of.len();
        for family in 0..3 {
            let mut rows = Mat::zeros(basis.size(), boxes);
            for b in 0..boxes {
                let from = basis.column(family, basis.strip_of[b]);
                for k in 0..basis.terms {
                    rows[(from + k, b)] = basis.polynomials[(b, k)];
                }
            }
            // correction of a box = row . x, x = prior L^-T z
            let in_units = lower_solve(metric_factor, &rows);
            let explained_by = &self.gain * &in_units;
            let loads = self.load_of_unit.transpose() * &in_units;
            for b in 0..boxes {
                let prior: f64 = (0..basis.size()).map(|k| in_units[(k, b)].powi(2)).sum();
                let told: f64 = (0..loads.nrows()).map(|r| loads[(r, b)] * explained_by[(r, b)]).sum();
                let left = (prior - told).max(0.0);
                ratio[family] += (left / prior).sqrt() / boxes as f64;
                sigma[family] += left * self.prior_spread.powi(2) / boxes as f64;
            }
        }
        (ratio, sigma.map(f64::sqrt))
    }

    /// Spread of the area-weighted mean of the force factor before and after the data.
    fn mean_force(&self, inputs: &Inputs<'_>, metric_factor: faer::MatRef<'_, f64>) -> [f64; 2] {
        let basis = inputs.basis;
        let mut mean = Mat::zeros(basis.size(), 1);
        for (b, share) in inputs.area_share.iter().enumerate() {
            let from = basis.column(0, basis.strip_of[b]);
            for k in 0..basis.terms {
                mean[(from + k, 0)] += share * basis.polynomials[(b, k)];
            }
        }
        let in_units = lower_solve(metric_factor, &mean);
        let explained_by = &self.gain * &in_units;
        let loads = self.load_of_unit.transpose() * &in_units;
        let prior: f64 = (0..basis.size()).map(|k| in_units[(k, 0)].powi(2)).sum();
        let told: f64 = (0..loads.nrows()).map(|r| loads[(r, 0)] * explained_by[(r, 0)]).sum();
        [prior, (prior - told).max(0.0)].map(|square| self.prior_spread * square.sqrt())
    }

    /// Posterior spread of the predicted loads by channel, rms over angles.
    fn predicted(&self, rows: &[(usize, usize)]) -> [f64; 4] {
        let signal = self.load_of_unit.transpose() * &self.load_of_unit;
        let told = (&self.gain * &self.load_of_unit).transpose() * &signal;
        let mut sums = [(0.0, 0); 4];
        for (r, &(channel, _)) in rows.iter().enumerate() {
            sums[channel].0 += (signal[(r, r)] - told[(r, r)]).max(0.0);
            sums[channel].1 += 1;
        }
        sums.map(|(sum, count)| if count > 0 { (sum / f64::from(count)).sqrt() } else { 0.0 })
    }
}

/// Share of each channel's sensitivity that runs through each family.
fn leverage(scaled: &Mat<f64>, rows: &[(usize, usize)], inputs: &Inputs<'_>) -> [[f64; 4]; 3] {
    let family_size = inputs.basis.size() / 3;
    let mut shares = [[0.0; 4]; 3];
    for channel in (0..4).filter(|&c| inputs.channels[c]) {
        let of = |family: usize| -> f64 {
            let columns = rows.iter().enumerate().filter(|(_, row)| row.0 == channel);
            columns
                .map(|(r, _)| {
                    (0..family_size).map(|k| scaled[(family * family_size + k, r)].powi(2)).sum::<f64>()
                })
                .sum()
        };
        let total: f64 = (0..3).map(of).sum();
        for (family, share) in shares.iter_mut().enumerate() {
            share[channel] = (of(family) / total.max(f64::MIN_POSITIVE)).sqrt();
        }
    }
    shares
}

/// Solves L y = b for several right sides.
fn lower_solve(lower: faer::MatRef<'_, f64>, right: &Mat<f64>) -> Mat<f64> {
    let mut solution = right.clone();
    lower.solve_lower_triangular_in_place(solution.as_mut());
    solution
}

#[cfg(test)]
mod tests;
