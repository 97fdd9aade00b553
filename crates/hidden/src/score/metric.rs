//! Metrics with their intervals.

use super::wilson::wilson;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// One metric.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Metric {
    /// Value; not a number without any case.
    pub value: Option<f64>,
    /// Lower end of the 95 % interval, of shares only.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub low: Option<f64>,
    /// Upper end.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub high: Option<f64>,
    /// Number of cases.
    pub n: usize,
}

impl Metric {
    /// A share of cases with Wilson's interval.
    pub(crate) fn share(hits: usize, n: usize) -> Self {
        let (low, high) = wilson(hits, n);
        let value = (n > 0).then(|| hits as f64 / n as f64);
        Self { value, low: Some(low), high: Some(high), n }
    }

    /// The share of those for which something holds.
    pub(crate) fn share_of<T>(cases: &[T], holds: impl Fn(&T) -> bool) -> Self {
        Self::share(cases.iter().filter(|case| holds(case)).count(), cases.len())
    }

    /// A number.
    pub(crate) fn number(value: Option<f64>, n: usize) -> Self {
        Self { value, low: None, high: None, n }
    }

    /// The mean of numbers.
    pub(crate) fn mean(values: &[f64]) -> Self {
        let n = values.len();
        Self::number((n > 0).then(|| values.iter().sum::<f64>() / n as f64), n)
    }

    /// The median of numbers.
    pub(crate) fn median(mut values: Vec<f64>) -> Self {
        values.sort_by(f64::total_cmp);
        let n = values.len();
        let middle = (n > 0).then(|| 0.5 * (values[(n - 1) / 2] + values[n / 2]));
        Self::number(middle, n)
    }
}

/// All metrics of a benchmark.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Metrics {
    /// Number of cases.
    pub cases: usize,
    /// Metrics by name; README.md of the crate says what each is.
    pub metrics: BTreeMap<String, Metric>,
    /// Number of cases by what was hidden, then by what was named (a confusion matrix); `none`, `unknown` and `data_defect` beside
    /// effects' names, pairs with a `+`.
    pub confusion: BTreeMap<String, BTreeMap<String, usize>>,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn half_of_the_numbers_are_below_a_median() {
        let median = |values: &[f64]| Metric::median(values.to_vec()).value;
        assert_eq!(median(&[5.0, 1.0, 4.0, 2.0]), Some(3.0));
        assert_eq!(median(&[9.0, 1.0, 5.0, 2.0, 3.0]), Some(3.0));
        assert_eq!(median(&[]), None);
    }
}
