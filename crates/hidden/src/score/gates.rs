//! What a release must reach: bounds of the metrics, decided before any case of the test seeds was judged.

use super::metric::Metrics;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// On which side of its bound a metric must lie.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Bound {
    /// Not below.
    AtLeast,
    /// Not above.
    AtMost,
}

/// A bound of a metric beside its value.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Gate {
    /// Name of the metric.
    pub metric: String,
    /// Side.
    pub bound: Bound,
    /// Bound.
    pub limit: f64,
    /// Value; none without cases.
    pub value: Option<f64>,
    /// Whether it is reached; not without cases.
    pub reached: bool,
}

const GATES: [(&str, Bound, f64); 22] = [
    ("null_false_naming", Bound::AtMost, 0.03),
    ("top1_clear", Bound::AtLeast, 0.95),
    ("top1_visible", Bound::AtLeast, 0.85),
    ("wrong_near_floor", Bound::AtMost, 0.10),
    ("precision", Bound::AtLeast, 0.92),
    ("precision_family", Bound::AtLeast, 0.98),
    ("set_coverage", Bound::AtLeast, 0.95),
    ("set_size", Bound::AtMost, 1.6),
    ("exact_structure", Bound::AtLeast, 0.85),
    ("extra_names", Bound::AtMost, 0.10),
    ("pair_both", Bound::AtLeast, 0.60),
    ("pair_one", Bound::AtLeast, 0.90),
    ("out_of_library_flagged", Bound::AtLeast, 1.0),
    ("out_of_library_misnamed", Bound::AtMost, 0.05),
    ("left_out_misnamed", Bound::AtMost, 0.05),
    ("confidence_ece", Bound::AtMost, 0.05),
    ("confidence_brier", Bound::AtMost, 0.08),
    ("parameter_error_median", Bound::AtMost, 0.15),
    ("gap_share_removed_median", Bound::AtLeast, 0.85),
    ("paper_exact", Bound::AtLeast, 1.0),
    ("seconds_mean", Bound::AtMost, 5.0),
    ("model_runs_mean", Bound::AtMost, 500.0),
];

/// Every gate with what a benchmark reached (point values; the intervals are the metrics').
pub fn gates(metrics: &Metrics) -> Vec<Gate> {
    let gate = |(name, bound, limit): &(&str, Bound, f64)| {
        let value = metrics.metrics.get(*name).and_then(|metric| metric.value);
        let reached = value.is_some_and(|value| match bound {
            Bound::AtLeast => value >= *limit,
            Bound::AtMost => value <= *limit,
        });
        Gate { metric: (*name).to_owned(), bound: *bound, limit: *limit, value, reached }
    };
    GATES.iter().map(gate).collect()
}
