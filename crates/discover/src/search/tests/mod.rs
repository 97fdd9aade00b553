//! What is named, taken back and left, where evidence and misfit have closed forms.

mod best;
mod parts;
mod step;
mod whole;

use super::*;
use crate::by_hand::{ByHand, made, size, steps};

/// A search of a problem that has not begun.
fn so_far<'a, 'n>(known: &'a ByHand, nulls: &'n NullDistribution) -> SoFar<'a, 'n> {
    let bare = known.bare();
    let (current, outcome) = (bare.clone(), Outcome::default());
    SoFar { bare, current, nulls, seed: 1, outcome, undecided: false }
}

/// Columns of ones: a and b on fifteen rows each. A measured m is fitted by 15/16 of it, and 15 m²/256 are left; on one
/// row that no column has there is what nothing explains.
fn columns(a: f64, b: f64, rest: f64) -> ByHand {
    ByHand::new(&[&steps(&[(0..15, a), (15..30, b), (30..31, rest)])])
        .column(made("a", &[], size()), &steps(&[(0..15, 1.0)]))
        .column(made("b", &[], size()), &steps(&[(15..30, 1.0)]))
}

/// Chi square of fifteen rows of m, before and after the fit.
fn squares(m: f64) -> [f64; 2] {
    [15.0 * m * m, 15.0 * m * m / 256.0]
}

/// Log Bayes factor of a column of [`columns`]: `(chi²_0 - chi²_e)/(2 phi) - x²/2 - ½ ln(1 + 15/phi)`.
fn evidence(m: f64, phi: f64) -> f64 {
    let [before, after] = squares(m);
    let size = 15.0 / 16.0 * m;
    0.5 * (before - after) / phi - 0.5 * size * size - 0.5 * (15.0 / phi).ln_1p()
}

fn close(a: f64, b: f64) {
    assert!((a - b).abs() < 1e-8 * (1.0 + b.abs()), "{a} {b}");
}
