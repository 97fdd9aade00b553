//! What a verdict rests on: pairs that fitted nothing, their line, their scatter, and chances.

use super::given::{Comparison, Gauge, Point, Thresholds, Zero};
use super::statistics::{Interval, Line, chance_above, mean, wilson};
use schemars::JsonSchema;
use serde::Serialize;

/// How many of the judged loads are calculated at least as large as measured.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
pub struct Conservative {
    /// So many.
    pub k: usize,
    /// Of so many.
    pub n: usize,
    /// Their share, with Wilson's interval.
    pub share: Interval,
}

/// A judged pair: a free zero is taken off the measured load.
#[derive(Debug, Clone, Copy)]
pub(super) struct Pair {
    calculated: f64,
    measured: f64,
    sigma: f64,
}

impl Pair {
    /// Calculated over measured.
    pub(super) fn ratio(&self) -> f64 {
        self.calculated / self.measured
    }

    /// How far the calculated load is below a share of the measured one, in standard deviations.
    pub(super) fn below(&self, share: f64) -> f64 {
        (share * self.measured.abs() - self.calculated * self.measured.signum()) / self.sigma
    }
}

/// What a verdict rests on.
pub(super) struct Facts {
    pub(super) pairs: Vec<Pair>,
    /// Places of large loads among the pairs.
    pub(super) large: Vec<usize>,
    pub(super) line: Option<Line>,
    pub(super) bias: Option<Interval>,
    pub(super) rms_percent: Option<f64>,
    pub(super) sigma: Option<f64>,
    /// Degrees of freedom of `sigma`, if it is found from the residuals.
    freedom: Option<f64>,
    factor_sigma: f64,
    pub(super) zero: Zero,
}

impl Facts {
    pub(super) fn of(one: &Comparison, thresholds: &Thresholds) -> Self {
        let judged: Vec<&Point> = one.points.iter().filter(|point| !point.fitted).collect();
        let calculated: Vec<f64> = judged.iter().map(|point| point.calculated).collect();
        let readings: Vec<f64> = judged.iter().map(|point| point.measured).collect();
        let line = Line::of(&calculated, &readings);
        let Gauge { sigma, factor_sigma, zero } = one.gauge;
        let (offset, offset_sigma) = match (zero, &line) {
            (Zero::Free, Some(line)) => (line.intercept.value, line.intercept_sigma()),
            _ => (0.0, 0.0),
        };
        let freedom = if sigma.is_none() { line.map(|line| line.freedom) } else { None };
        let sigma = sigma.or(line.map(|line| line.residual_sigma));
        let pair = |point: &&Point| {
            let measured = point.measured - offset;
            let parts = [sigma.unwrap_or(0.0), factor_sigma * measured, point.state_sigma, offset_sigma];
            let square: f64 = parts.iter().map(|part| part * part).sum();
            Pair { calculated: point.calculated, measured, sigma: square.sqrt() }
        };
        let pairs: Vec<Pair> = judged.iter().map(pair).collect();
        let largest = pairs.iter().map(|pair| pair.measured.abs()).fold(0.0, f64::max);
        let is_large =
            |pair: &Pair| pair.measured != 0.0 && pair.measured.abs() >= thresholds.large_from * largest;
        let large = (0..pairs.len()).filter(|&at| is_large(&pairs[at])).collect();
        let off: Vec<f64> = pairs.iter().map(|pair| pair.calculated - pair.measured).collect();
        let ends = |pick: fn(f64, f64) -> f64, from| pairs.iter().map(|pair| pair.measured).fold(from, pick);
        let range = ends(f64::max, f64::MIN) - ends(f64::min, f64::MAX);
        let rms = (off.iter().map(|off| off * off).sum::<f64>() / off.len().max(1) as f64).sqrt();
        Self {
            large,
            line,
            bias: mean(&off),
            rms_percent: (pairs.len() > 1 && range > 0.0).then(|| 100.0 * rms / range),
            sigma,
            freedom,
            factor_sigma,
            zero,
            pairs,
        }
    }

    pub(super) fn large(&self) -> impl Iterator<Item = &Pair> {
        self.large.iter().map(|&at| &self.pairs[at])
    }

    pub(super) fn worst_ratio(&self) -> Option<f64> {
        self.large().map(Pair::ratio).reduce(f64::min)
    }

    /// Of the same sign and at least as large.
    pub(super) fn conservative(&self) -> Conservative {
        let is = |pair: &&Pair| pair.calculated * pair.measured.signum() >= pair.measured.abs();
        let (k, n) = (self.pairs.iter().filter(is).count(), self.pairs.len());
        Conservative { k, n, share: wilson(k, n) }
    }

    /// Slope with the error of the gauge's factor.
    pub(super) fn slope(&self) -> Option<Interval> {
        self.line.map(|line| line.slope.widened(line.slope.value * self.factor_sigma))
    }

    /// Number of tests: each large load, and the slope if there is one.
    pub(super) fn tests(&self) -> usize {
        if self.sigma.is_none() { 0 } else { self.large.len() + usize::from(self.line.is_some()) }
    }

    /// Chances of what is seen if loads were calculated just large enough.
    pub(super) fn chances(&self, thresholds: &Thresholds) -> Vec<f64> {
        if self.sigma.is_none() {
            return Vec::new();
        }
        let r = thresholds.reliable_within;
        let points = self.large().map(|pair| chance_above(pair.below(1.0 - r), self.freedom));
        let slope = self.line.map(|line| {
            let sigma = line.slope_sigma().hypot(line.slope.value * self.factor_sigma);
            chance_above((line.slope.value - 1.0 - r) / sigma, Some(line.freedom))
        });
        points.chain(slope).collect()
    }
}
