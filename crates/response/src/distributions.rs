//! Probabilities and quantiles of the t, F and normal distributions, at the levels that statistics asks for.

use statrs::distribution::{ContinuousCDF, FisherSnedecor, Normal, StudentsT};

use crate::fault::Fault;

/// Demands a probability strictly between 0 and 1.
pub(crate) fn probability(what: &'static str, value: f64) -> Result<(), Fault> {
    Fault::unless(value > 0.0 && value < 1.0, what, value, "a probability between 0 and 1")
}

/// The number that |t| stays below with a probability of `level`.
pub(crate) fn t_quantile(level: f64, freedom: f64) -> Result<f64, Fault> {
    probability("the level", level)?;
    let wrong = Fault::Number { what: "degrees of freedom", value: freedom, expected: "more than 0" };
    let distribution = StudentsT::new(0.0, 1.0, freedom).map_err(|_| wrong)?;
    Ok(distribution.inverse_cdf(0.5 + 0.5 * level))
}

/// The interval about a value that holds the true one with a probability of `level`.
pub(crate) fn t_interval(value: f64, sigma: f64, level: f64, freedom: f64) -> Result<(f64, f64), Fault> {
    let half = t_quantile(level, freedom)? * sigma;
    Ok((value - half, value + half))
}

/// Probability of a |t| this large or larger; 0 for an infinite one, 1 for 0/0.
pub(crate) fn two_sided_t(t: f64, freedom: f64) -> f64 {
    if t.is_nan() {
        return 1.0;
    }
    StudentsT::new(0.0, 1.0, freedom).map_or(1.0, |distribution| 2.0 * distribution.cdf(-t.abs()))
}

/// Probability of an F this large or larger.
pub(crate) fn upper_f(f: f64, above: f64, below: f64) -> f64 {
    if f.is_nan() {
        return 1.0;
    }
    if f.is_infinite() {
        return 0.0;
    }
    FisherSnedecor::new(above, below).map_or(1.0, |distribution| distribution.sf(f.max(0.0)))
}

/// Quantile of the standard normal distribution.
pub(crate) fn normal_quantile(probability: f64) -> f64 {
    Normal::standard().inverse_cdf(probability)
}

/// Probability of a standard normal number below `z`.
pub(crate) fn normal_below(z: f64) -> f64 {
    Normal::standard().cdf(z)
}
