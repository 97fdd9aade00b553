//! Measured against calculated loads: statistics and verdicts by condition, station and load.
//!
//! Whether calculated loads are too small is one question for all points, stations and loads together: each large load that is
//! calculated below (1 - r) of the measured is a test by itself, so are slopes, and Holm's steps keep the chance of one false alarm
//! among them at 2.5 %. Errors of a gauge's calibration are shared by its points, which Holm's steps allow for.

pub mod statistics;
mod verdict;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use statistics::{Interval, Line, chance_above, holm, mean, wilson};
pub use verdict::Verdict;

/// Chance of a false `unconservative` among all tests.
pub const LEVEL: f64 = 0.025;

/// What is asked of calculated loads. The numbers are the user's: no rule is known that gives them.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
pub struct Thresholds {
    /// Slopes within one plus and minus this are reliable.
    pub reliable_within: f64,
    /// Bias within so many standard deviations of the measurement is reliable.
    pub bias_within_sigma: f64,
    /// Loads from this share of the largest measured one on are large.
    pub large_from: f64,
}

/// Whether the reading without load is known.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize, Serialize, JsonSchema)]
pub enum Zero {
    /// Readings are loads.
    #[default]
    Known,
    /// Readings have an unknown offset: it is found with the slope, and says nothing of the model.
    Free,
}

/// A gauge as its calibration left it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Gauge {
    /// Standard deviation of a reading, N or N m; unknown: that of the residuals.
    pub sigma: Option<f64>,
    /// Standard deviation of the gauge's factor, share: the same error in all its readings.
    pub factor_sigma: f64,
    /// Its zero.
    pub zero: Zero,
}

/// A measured load beside the calculated one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Point {
    /// Calculated at the measured state, N or N m.
    pub calculated: f64,
    /// Measured, N or N m.
    pub measured: f64,
    /// Standard deviation of the calculated load for noise in the measured state, N or N m.
    pub state_sigma: f64,
    /// Whether it fitted the model's corrections: then it counts in no verdict.
    pub fitted: bool,
}

/// A load at a station in a condition, measured and calculated by one model.
#[derive(Debug, Clone, PartialEq)]
pub struct Comparison {
    /// Condition, station and load in words.
    pub name: String,
    /// Unit of the load.
    pub unit: &'static str,
    /// The gauge.
    pub gauge: Gauge,
    /// Points.
    pub points: Vec<Point>,
}

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

/// What comes of a comparison.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct Judged {
    /// Points that are judged.
    pub points: usize,
    /// Points that fitted the corrections and are not.
    pub fitted: usize,
    /// Measured on calculated; none of fewer than three points.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub line: Option<Line>,
    /// Mean of calculated minus measured, N or N m.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub bias: Option<Interval>,
    /// Root mean square of calculated minus measured, percent of the measured range.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub rms_percent: Option<f64>,
    /// Standard deviation of a measurement that the verdict rests on, N or N m.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub sigma: Option<f64>,
    /// Number of large loads.
    pub large: usize,
    /// Smallest calculated over measured among them.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub worst_ratio: Option<f64>,
    /// How many are conservative.
    pub conservative: Conservative,
    /// The verdict.
    pub verdict: Verdict,
    /// Why.
    pub reasons: Vec<String>,
}

/// Judges all comparisons of one model together.
pub fn judge(all: &[Comparison], thresholds: &Thresholds) -> Vec<Judged> {
    let facts: Vec<Facts> = all.iter().map(|one| Facts::of(one, thresholds)).collect();
    let chances: Vec<f64> = facts.iter().flat_map(|facts| facts.chances(thresholds)).collect();
    let mut found = holm(&chances, LEVEL).into_iter();
    let each = all.iter().zip(&facts).map(|(one, facts)| {
        let found: Vec<bool> = found.by_ref().take(facts.tests()).collect();
        let (verdict, reasons) = verdict::verdict(facts, thresholds, &found, one.unit);
        Judged {
            points: facts.pairs.len(),
            fitted: one.points.len() - facts.pairs.len(),
            line: facts.line,
            bias: facts.bias,
            rms_percent: facts.rms_percent,
            sigma: facts.sigma,
            large: facts.large.len(),
            worst_ratio: facts.worst_ratio(),
            conservative: facts.conservative(),
            verdict,
            reasons,
        }
    });
    each.collect()
}

/// A judged pair: a free zero is taken off the measured load.
#[derive(Debug, Clone, Copy)]
struct Pair {
    calculated: f64,
    measured: f64,
    sigma: f64,
}

impl Pair {
    fn ratio(&self) -> f64 {
        self.calculated / self.measured
    }

    /// How far the calculated load is below a share of the measured one, in standard deviations.
    fn below(&self, share: f64) -> f64 {
        (share * self.measured.abs() - self.calculated * self.measured.signum()) / self.sigma
    }
}

/// What a verdict rests on.
struct Facts {
    pairs: Vec<Pair>,
    /// Places of large loads among the pairs.
    large: Vec<usize>,
    line: Option<Line>,
    bias: Option<Interval>,
    rms_percent: Option<f64>,
    sigma: Option<f64>,
    /// Degrees of freedom of `sigma`, if it is found from the residuals.
    freedom: Option<f64>,
    factor_sigma: f64,
    zero: Zero,
}

impl Facts {
    fn of(one: &Comparison, thresholds: &Thresholds) -> Self {
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

    fn large(&self) -> impl Iterator<Item = &Pair> {
        self.large.iter().map(|&at| &self.pairs[at])
    }

    fn worst_ratio(&self) -> Option<f64> {
        self.large().map(Pair::ratio).reduce(f64::min)
    }

    /// Of the same sign and at least as large.
    fn conservative(&self) -> Conservative {
        let is = |pair: &&Pair| pair.calculated * pair.measured.signum() >= pair.measured.abs();
        let (k, n) = (self.pairs.iter().filter(is).count(), self.pairs.len());
        Conservative { k, n, share: wilson(k, n) }
    }

    /// Slope with the error of the gauge's factor.
    fn slope(&self) -> Option<Interval> {
        self.line.map(|line| line.slope.widened(line.slope.value * self.factor_sigma))
    }

    /// Number of tests: each large load, and the slope if there is one.
    fn tests(&self) -> usize {
        if self.sigma.is_none() { 0 } else { self.large.len() + usize::from(self.line.is_some()) }
    }

    /// Chances of what is seen if loads were calculated just large enough.
    fn chances(&self, thresholds: &Thresholds) -> Vec<f64> {
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
