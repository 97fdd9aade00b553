//! Which of many effects are real when nothing was repeated: normal and half-normal plots (Daniel, Technometrics 1 (1959)),
//! on which noise lies on a line through zero, and Lenth's pseudo standard error with its margins (Technometrics 31 (1989)).

use schemars::JsonSchema;
use serde::Serialize;

use crate::distributions::{normal_quantile, probability, t_quantile};
use crate::fault::Fault;

/// Lenth's pseudo standard error and margins of effects, in the unit of the effects.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
pub struct Lenth {
    /// 1.5 times the median size of those effects that are below 2.5 times 1.5 times the median size of all.
    pub pseudo_standard_error: f64,
    /// Margin of error: an effect beyond it is real, if it were the only one looked at.
    pub margin: f64,
    /// Simultaneous margin of error: an effect beyond it is real among all that were looked at.
    pub simultaneous_margin: f64,
}

impl Lenth {
    /// From the effects; `level` is 0.95 for 5 % false alarms.
    ///
    /// # Errors
    /// If there are fewer than 3 effects, or the level is not between 0 and 1.
    pub fn of(effects: &[f64], level: f64) -> Result<Self, Fault> {
        probability("the level", level)?;
        let count = effects.len() as f64;
        Fault::unless(count >= 3.0, "the number of effects", count, "3 or more for Lenth's margins")?;
        let sizes: Vec<f64> = effects.iter().map(|effect| effect.abs()).collect();
        let first = 1.5 * median(&sizes);
        let small: Vec<f64> = sizes.iter().copied().filter(|size| *size < 2.5 * first).collect();
        let pseudo_standard_error = 1.5 * median(&small);
        let freedom = count / 3.0;
        // level^(1/count) for each makes level for all
        let margin = pseudo_standard_error * t_quantile(level, freedom)?;
        let simultaneous_margin = pseudo_standard_error * t_quantile(level.powf(1.0 / count), freedom)?;
        Ok(Self { pseudo_standard_error, margin, simultaneous_margin })
    }
}

fn median(values: &[f64]) -> f64 {
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    match sorted.len() {
        0 => 0.0,
        n if n % 2 == 1 => sorted[n / 2],
        n => 0.5 * (sorted[n / 2 - 1] + sorted[n / 2]),
    }
}

/// A point of a probability plot.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PlotPoint {
    /// Which effect.
    pub index: usize,
    /// The effect, or its size on a half-normal plot.
    pub effect: f64,
    /// Where pure noise of standard deviation 1 would have it.
    pub quantile: f64,
}

/// Normal plot: effects in rising order over the normal quantiles of (i - 1/2) / n.
pub fn normal_plot(effects: &[f64]) -> Vec<PlotPoint> {
    plot(effects, normal_quantile)
}

/// Half-normal plot: sizes of effects in rising order over the normal quantiles of 1/2 + (i - 1/2) / 2n.
pub fn half_normal_plot(effects: &[f64]) -> Vec<PlotPoint> {
    let sizes: Vec<f64> = effects.iter().map(|effect| effect.abs()).collect();
    plot(&sizes, |share| normal_quantile(0.5 + 0.5 * share))
}

fn plot(values: &[f64], quantile: impl Fn(f64) -> f64) -> Vec<PlotPoint> {
    let mut order: Vec<usize> = (0..values.len()).collect();
    order.sort_by(|a, b| values[*a].total_cmp(&values[*b]));
    let share = |rank: usize| (rank as f64 + 0.5) / values.len() as f64;
    let point = |(rank, index)| PlotPoint { index, effect: values[index], quantile: quantile(share(rank)) };
    order.into_iter().enumerate().map(point).collect()
}
