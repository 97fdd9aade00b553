//! Straight lines through points, and shares, with their intervals.

use schemars::JsonSchema;
use serde::Serialize;
use statrs::distribution::{ContinuousCDF, Normal, StudentsT};

/// Confidence of all intervals.
pub const CONFIDENCE: f64 = 0.95;

/// A number with its 95 % interval.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
pub struct Interval {
    /// The number.
    pub value: f64,
    /// Lower end.
    pub low: f64,
    /// Upper end.
    pub high: f64,
}

impl Interval {
    fn around(value: f64, half: f64) -> Self {
        Self { value, low: value - half, high: value + half }
    }

    /// The same with a further error that is not of these points (a standard deviation).
    #[must_use]
    pub(crate) fn widened(self, sigma: f64) -> Self {
        let half =
            (self.high - self.value).hypot(standard().inverse_cdf(f64::midpoint(1.0, CONFIDENCE)) * sigma);
        Self::around(self.value, half)
    }
}

/// Least squares of measured on calculated values.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
pub struct Line {
    /// Slope.
    pub slope: Interval,
    /// Measured where nothing is calculated, N or N m.
    pub intercept: Interval,
    /// Slope of the line through zero.
    pub slope_through_zero: Interval,
    /// Share of the measured variance that the line takes away.
    pub r2: f64,
    /// Standard deviation of the residuals, N or N m.
    pub residual_sigma: f64,
    /// Points less two.
    #[serde(skip)]
    pub(crate) freedom: f64,
}

impl Line {
    /// A line with t intervals; none of fewer than three points, or if all calculated values are the same.
    pub fn of(calculated: &[f64], measured: &[f64]) -> Option<Self> {
        let n = calculated.len();
        if n < 3 {
            return None;
        }
        let count = n as f64;
        let mean = |values: &[f64]| values.iter().sum::<f64>() / count;
        let (x0, y0) = (mean(calculated), mean(measured));
        let pairs = || calculated.iter().zip(measured);
        let sxx: f64 = calculated.iter().map(|x| (x - x0).powi(2)).sum();
        let syy: f64 = measured.iter().map(|y| (y - y0).powi(2)).sum();
        let sxy: f64 = pairs().map(|(x, y)| (x - x0) * (y - y0)).sum();
        let square: f64 = calculated.iter().map(|x| x * x).sum();
        if sxx <= f64::EPSILON * square {
            return None;
        }
        let slope = sxy / sxx;
        let intercept = y0 - slope * x0;
        let left: f64 = pairs().map(|(x, y)| (y - intercept - slope * x).powi(2)).sum();
        let residual_sigma = (left / (count - 2.0)).sqrt();
        let t = t_quantile(count - 2.0);
        let through = pairs().map(|(x, y)| x * y).sum::<f64>() / square;
        let left_through: f64 = pairs().map(|(x, y)| (y - through * x).powi(2)).sum();
        let sigma_through = (left_through / (count - 1.0) / square).sqrt();
        Some(Self {
            slope: Interval::around(slope, t * residual_sigma / sxx.sqrt()),
            intercept: Interval::around(intercept, t * residual_sigma * (1.0 / count + x0 * x0 / sxx).sqrt()),
            slope_through_zero: Interval::around(through, t_quantile(count - 1.0) * sigma_through),
            r2: if syy > 0.0 { sxy * sxy / (sxx * syy) } else { 0.0 },
            residual_sigma,
            freedom: count - 2.0,
        })
    }

    /// Standard deviation of the slope.
    pub(crate) fn slope_sigma(&self) -> f64 {
        (self.slope.high - self.slope.value) / t_quantile(self.freedom)
    }

    /// Standard deviation of the intercept, N or N m.
    pub(crate) fn intercept_sigma(&self) -> f64 {
        (self.intercept.high - self.intercept.value) / t_quantile(self.freedom)
    }
}

/// The mean of some numbers with its t interval; none of fewer than two.
pub fn mean(values: &[f64]) -> Option<Interval> {
    let count = values.len() as f64;
    if values.len() < 2 {
        return None;
    }
    let mean = values.iter().sum::<f64>() / count;
    let square: f64 = values.iter().map(|value| (value - mean).powi(2)).sum();
    Some(Interval::around(mean, t_quantile(count - 1.0) * (square / (count - 1.0) / count).sqrt()))
}

/// Wilson's interval of a share `k` of `n`.
pub fn wilson(k: usize, n: usize) -> Interval {
    if n == 0 {
        return Interval { value: 0.0, low: 0.0, high: 1.0 };
    }
    let (count, share) = (n as f64, k as f64 / n as f64);
    let z = standard().inverse_cdf(f64::midpoint(1.0, CONFIDENCE));
    let scale = 1.0 + z * z / count;
    let centre = (share + z * z / (2.0 * count)) / scale;
    let half = z / scale * (share * (1.0 - share) / count + z * z / (4.0 * count * count)).sqrt();
    Interval { value: share, low: (centre - half).max(0.0), high: (centre + half).min(1.0) }
}

/// Chance that a number of Student's distribution (the normal one without `freedom`) is above `t`.
pub(crate) fn chance_above(t: f64, freedom: Option<f64>) -> f64 {
    match freedom.and_then(|freedom| StudentsT::new(0.0, 1.0, freedom).ok()) {
        Some(student) => student.cdf(-t),
        None => standard().cdf(-t),
    }
}

/// Which of these chances are too small to be chance, all together at a level: Holm's steps.
pub fn holm(chances: &[f64], level: f64) -> Vec<bool> {
    let mut order: Vec<usize> = (0..chances.len()).collect();
    order.sort_by(|a, b| chances[*a].total_cmp(&chances[*b]));
    let mut found = vec![false; chances.len()];
    for (step, place) in order.into_iter().enumerate() {
        if chances[place] > level / (chances.len() - step) as f64 {
            break;
        }
        found[place] = true;
    }
    found
}

fn t_quantile(freedom: f64) -> f64 {
    StudentsT::new(0.0, 1.0, freedom)
        .map_or(f64::INFINITY, |student| student.inverse_cdf(f64::midpoint(1.0, CONFIDENCE)))
}

fn standard() -> Normal {
    Normal::standard()
}
