//! An ensemble: wings that are as likely as the calibrated one's uncertainty lets them be, so that whatever is computed with the
//! calibrated wing can be computed with each of them, and its interval read from how far they spread.
//!
//! `calibrate` writes it as `ensemble.ron` beside `corrections.ron`.

mod file;
mod members;
mod moved;

pub use file::{Ensemble, Member};
pub use members::ensemble;

use crate::HALF_90;

/// The 90 % interval of what the calibrated wing has as `value` and the wings of an ensemble as `members`.
pub fn interval(value: f64, members: &[f64]) -> [f64; 2] {
    interval_of(value, &[members.to_vec()])
}

/// The same with several sources of uncertainty that know nothing of each other, each with its own wings: variances add.
pub fn interval_of(value: f64, sources: &[Vec<f64>]) -> [f64; 2] {
    let variance = |members: &Vec<f64>| {
        let squares: f64 = members.iter().map(|member| (member - value).powi(2)).sum();
        squares / members.len().max(1) as f64
    };
    let half = HALF_90 * sources.iter().map(variance).sum::<f64>().sqrt();
    [value - half, value + half]
}
