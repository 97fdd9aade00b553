//! Random blocks: offsets drawn with a variance of their own. The ratio theta of the block variance to that of the errors
//! maximises the restricted likelihood (Patterson and Thompson, Biometrika 58 (1971)), which for one block column has V =
//! I + theta Z Z' with a closed form for every root: subtracting the share 1 - 1 / sqrt(1 + n theta) of its mean from each
//! block of n points makes errors independent. So one number is searched, by golden sections.

use crate::columns::Columns;
use crate::data::Blocks;
use crate::fault::Fault;
use crate::qr::dot;

/// Largest ratio of the variances that is looked for.
const LARGEST_RATIO: f64 = 1e6;

/// A column with the share of its block means taken out.
pub(crate) fn transformed(column: &[f64], blocks: &Blocks, ratio: f64) -> Vec<f64> {
    let sizes = blocks.sizes();
    let mut means = vec![0.0; sizes.len()];
    column.iter().zip(&blocks.of_point).for_each(|(value, block)| means[*block] += value);
    for (mean, size) in means.iter_mut().zip(&sizes) {
        let size = *size as f64;
        *mean *= (1.0 - 1.0 / (1.0 + size * ratio).sqrt()) / size;
    }
    column.iter().zip(&blocks.of_point).map(|(value, block)| value - means[*block]).collect()
}

/// All columns of a model so.
pub(crate) fn decorrelated(columns: &Columns, blocks: &Blocks, ratio: f64) -> Columns {
    let of = |column: &Vec<f64>| transformed(column, blocks, ratio);
    Columns { names: columns.names.clone(), values: columns.values.iter().map(of).collect() }
}

/// Minus twice the restricted log likelihood, but for a constant.
fn deviance(columns: &Columns, y: &[f64], blocks: &Blocks, ratio: f64) -> Result<f64, Fault> {
    let qr = decorrelated(columns, blocks, ratio).orthogonalised()?;
    let (rest, _) = qr.remainder(&transformed(y, blocks, ratio));
    let freedom = (y.len() - columns.len()) as f64;
    let of_v: f64 = blocks.sizes().iter().map(|size| (*size as f64 * ratio).ln_1p()).sum();
    Ok(freedom * dot(&rest, &rest).ln() + of_v + qr.log_determinant())
}

/// The ratio of the block variance to the variance of errors; 0 if blocks explain nothing.
pub(crate) fn variance_ratio(columns: &Columns, y: &[f64], blocks: &Blocks) -> Result<f64, Fault> {
    let at = |log: f64| deviance(columns, y, blocks, log.exp());
    // a coarse look first: the likelihood of unbalanced blocks can have two maxima
    let (low, high) = (1e-6_f64.ln(), LARGEST_RATIO.ln());
    let step = (high - low) / 40.0;
    let mut best = (low, at(low)?);
    for k in 1..=40 {
        let log = low + step * f64::from(k);
        let value = at(log)?;
        if value < best.1 {
            best = (log, value);
        }
    }
    let log = golden(best.0 - step, best.0 + step, at)?;
    let zero = deviance(columns, y, blocks, 0.0)?;
    Ok(if at(log)? < zero { log.exp() } else { 0.0 })
}

fn golden(mut low: f64, mut high: f64, of: impl Fn(f64) -> Result<f64, Fault>) -> Result<f64, Fault> {
    let share = 0.5 * (5.0_f64.sqrt() - 1.0);
    let (mut a, mut b) = (high - share * (high - low), low + share * (high - low));
    let (mut of_a, mut of_b) = (of(a)?, of(b)?);
    while high - low > 1e-7 {
        if of_a <= of_b {
            (high, b, of_b) = (b, a, of_a);
            a = high - share * (high - low);
            of_a = of(a)?;
        } else {
            (low, a, of_a) = (a, b, of_b);
            b = low + share * (high - low);
            of_b = of(b)?;
        }
    }
    Ok(0.5 * (low + high))
}
