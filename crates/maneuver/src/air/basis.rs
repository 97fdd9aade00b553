//! The functions of p that a rational approximation is made of, and the least squares fit with given poles.

use faer::Mat;
use faer::linalg::solvers::SolveLstsq;

/// Maps data at the table's frequencies to coefficients of `p`, `p²` (unless left out) and `p/(p + pole)`.
pub(super) struct Basis {
    /// Coefficients by (real parts, imaginary parts).
    pub(super) solver: Mat<f64>,
    /// (Real parts, imaginary parts) by coefficients, unweighted.
    pub(super) functions: Mat<f64>,
}

impl Basis {
    /// The fit at given frequencies with given poles, both in 1/m; `knee` as in [`Weighting`](super::rational::Weighting),
    /// `second` if there is a term in p².
    pub(super) fn new(kappa: &[f64], poles: &[f64], knee: f64, second: bool) -> Self {
        let powers = 1 + usize::from(second);
        let (n, unknowns) = (kappa.len(), powers + poles.len());
        let highest = kappa.iter().copied().fold(f64::MIN_POSITIVE, f64::max);
        let functions = Mat::from_fn(2 * n, unknowns, |row, function| {
            let k = kappa[row % n];
            let imaginary = row >= n;
            match (function, imaginary) {
                (0, false) => 0.0,
                (0, true) => k,
                (1, true) if second => 0.0,
                (1, false) if second => -k * k,
                // i k / (i k + g) = (k² + i k g) / (k² + g²)
                (lag, _) => {
                    let g = poles[lag - powers];
                    k * if imaginary { g } else { k } / (k * k + g * g)
                }
            }
        });
        let weight = |row: usize| 1.0 / (knee + kappa[row % n] / highest);
        // columns of size one, so that the triangle of the factorisation is well conditioned
        let size: Vec<f64> = (0..unknowns)
            .map(|c| (0..2 * n).map(|r| (weight(r) * functions[(r, c)]).powi(2)).sum::<f64>().sqrt())
            .collect();
        let scaled = Mat::from_fn(2 * n, unknowns, |r, c| weight(r) * functions[(r, c)] / size[c]);
        let units = Mat::from_fn(2 * n, 2 * n, |r, c| if r == c { weight(r) } else { 0.0 });
        let solution = scaled.qr().solve_lstsq(units);
        let solver = Mat::from_fn(unknowns, 2 * n, |r, c| solution[(r, c)] / size[r]);
        Self { solver, functions }
    }
}
