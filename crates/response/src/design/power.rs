//! What a planned experiment can see: the power of the two-sided t test of a coefficient, from the noncentral t
//! distribution, P(T <= t) = integral of Phi(t s - delta) over s, the ratio of estimated to true standard deviation.

use statrs::function::gamma::ln_gamma;

use super::Design;
use crate::data::Blocks;
use crate::distributions::{normal_below, probability, t_quantile};
use crate::fault::Fault;
use crate::term::Term;

/// Intervals of the integral.
const INTERVALS: i32 = 2000;

/// P(T <= t) of the noncentral t distribution.
fn noncentral_t_below(t: f64, freedom: f64, delta: f64) -> f64 {
    // density of s = sqrt(chi^2 / freedom), within 10 standard deviations of it
    let constant = 0.5 * freedom * (0.5 * freedom).ln() - ln_gamma(0.5 * freedom) + std::f64::consts::LN_2;
    let density = |s: f64| (constant + (freedom - 1.0) * s.ln() - 0.5 * freedom * s * s).exp();
    let width = 10.0 / (2.0 * freedom).sqrt();
    let (low, high) = ((1.0 - width).max(1e-12), 1.0 + width);
    let step = (high - low) / f64::from(INTERVALS);
    let weighted = |k: i32| {
        let s = low + step * f64::from(k);
        let weight = match k {
            0 | INTERVALS => 1.0,
            k if k % 2 == 1 => 4.0,
            _ => 2.0,
        };
        weight * density(s) * normal_below(t * s - delta)
    };
    (0..=INTERVALS).map(weighted).sum::<f64>() * step / 3.0
}

/// Probability that a two-sided t test at `level` (0.95: 5 % false alarms) finds an effect of `noncentrality` standard
/// errors.
///
/// # Errors
/// If the level is not between 0 and 1 or the degrees of freedom are below 1.
pub fn power(noncentrality: f64, degrees_of_freedom: f64, level: f64) -> Result<f64, Fault> {
    let expected = "1 or more: replicates, or fewer terms";
    Fault::unless(degrees_of_freedom >= 1.0, "degrees of freedom", degrees_of_freedom, expected)?;
    let limit = t_quantile(level, degrees_of_freedom)?;
    let below = |t| noncentral_t_below(t, degrees_of_freedom, noncentrality.abs());
    Ok((1.0 - below(limit) + below(-limit)).clamp(0.0, 1.0))
}

/// The effect in standard errors that is found with the given probability.
///
/// # Errors
/// As [`power`], and if the probability is not between 1 - level and 1.
pub fn detectable_noncentrality(degrees_of_freedom: f64, level: f64, wanted: f64) -> Result<f64, Fault> {
    probability("the power", wanted)?;
    let (mut low, mut high) = (0.0, 1.0);
    let by_false_alarm = power(low, degrees_of_freedom, level)?;
    let expected = "more than what the test finds by false alarm";
    Fault::unless(by_false_alarm <= wanted, "the power", wanted, expected)?;
    while power(high, degrees_of_freedom, level)? < wanted {
        high *= 2.0;
        Fault::unless(high <= 1e6, "the power", wanted, "one that can be reached")?;
    }
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if power(middle, degrees_of_freedom, level)? < wanted { low = middle } else { high = middle }
    }
    Ok(0.5 * (low + high))
}

/// Of each term the smallest true coefficient (in the unit of `sigma`, the standard deviation of one reading) that the
/// experiment finds with the given probability; an effect from low to high is twice that.
///
/// # Errors
/// If the design has no term's factor, cannot tell the terms apart or leaves no degree of freedom; as
/// [`detectable_noncentrality`].
pub fn smallest_effects(
    design: &Design,
    terms: &[Term],
    blocks: &[Blocks],
    sigma: f64,
    (level, wanted): (f64, f64),
) -> Result<Vec<(Term, f64)>, Fault> {
    let columns = design.columns(terms)?.with_blocks(blocks);
    let points = design.points().len();
    if points <= columns.len() {
        let needs = " and an estimate of the error";
        return Err(Fault::TooFewPoints { points, terms: columns.len(), needs });
    }
    let qr = columns.orthogonalised()?;
    let delta = detectable_noncentrality((points - columns.len()) as f64, level, wanted)?;
    let smallest = |(k, term): (usize, &Term)| (term.clone(), delta * sigma * qr.leverage_of(k).sqrt());
    Ok(terms.iter().enumerate().map(smallest).collect())
}
