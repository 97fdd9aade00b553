//! What is compared, and what is asked of it.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

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
