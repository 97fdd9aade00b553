//! Measured against calculated loads: statistics and verdicts by condition, station and load.
//!
//! Whether calculated loads are too small is one question for all points, stations and loads together: each large load that is
//! calculated below (1 - r) of the measured is a test by itself, so are slopes, and Holm's steps keep the chance of one false alarm
//! among them at 2.5 %. Errors of a gauge's calibration are shared by its points, which Holm's steps allow for.

pub mod coverage;
mod facts;
mod given;
pub mod statistics;
mod verdict;

pub use facts::Conservative;
use facts::Facts;
pub use given::{Comparison, Gauge, Point, Thresholds, Zero};
use schemars::JsonSchema;
use serde::Serialize;
use statistics::{Interval, Line, holm};
pub use verdict::Verdict;

/// Chance of a false `unconservative` among all tests.
pub const LEVEL: f64 = 0.025;

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
