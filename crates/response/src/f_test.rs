//! The F test: a mean square over another that it should be like.

use schemars::JsonSchema;
use serde::Serialize;

use crate::distributions::upper_f;

/// An F test.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
pub struct FTest {
    /// Ratio of the mean squares.
    #[schemars(with = "Option<f64>")]
    pub f: f64,
    /// Degrees of freedom of the upper one.
    pub above: f64,
    /// Degrees of freedom of the lower one.
    pub below: f64,
    /// Probability of an F as large by chance.
    #[schemars(with = "Option<f64>")]
    pub p_value: f64,
}

impl FTest {
    /// From sums of squares and their degrees of freedom.
    pub fn new(sum_above: f64, above: f64, sum_below: f64, below: f64) -> Self {
        let f = (sum_above.max(0.0) / above) / (sum_below / below);
        Self { f, above, below, p_value: upper_f(f, above, below) }
    }
}
