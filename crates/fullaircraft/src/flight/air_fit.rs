//! The least squares fit of the rational function with given poles, for motions with and without a term in p².
//!
//! The same weights for every entry, so the fit is linear in the data: sums of rows stay sums, and rows that carry
//! corrections, areas and shapes may be applied after it. Errors count alike far below the table's highest frequency and less above
//! it.

use faer::linalg::solvers::SolveLstsq;
use faer::{Mat, MatRef};
use maneuver::air::{AirTable, RationalAir};

/// Share of the table's highest frequency below which errors count alike.
const KNEE: f64 = 0.05;

/// The fit of a table with given poles (1/m) and steady pressures; `incidence` tells the columns without p².
pub(crate) fn fit(
    table: &AirTable,
    steady: Mat<f64>,
    poles_per_m: &[f64],
    incidence: impl Fn(usize) -> bool,
) -> RationalAir {
    let kappa = &table.omega_over_v_per_m;
    let solvers = [solver(kappa, poles_per_m, true), solver(kappa, poles_per_m, false)];
    let n = kappa.len();
    let coefficient = |function: usize| {
        Mat::from_fn(steady.nrows(), steady.ncols(), |j, column| {
            let plain = incidence(column);
            // without p² the list of functions is one shorter
            let row = match (plain, function) {
                (true, 1) => return 0.0,
                (true, lag) if lag > 1 => lag - 1,
                (_, function) => function,
            };
            let solver = &solvers[usize::from(plain)];
            let at_rest = steady[(j, column)];
            table
                .cp
                .iter()
                .enumerate()
                .map(|(k, cp)| {
                    let value = cp[(j, column)];
                    solver[(row, k)] * (value.re - at_rest) + solver[(row, n + k)] * value.im
                })
                .sum()
        })
    };
    RationalAir {
        rate: coefficient(0),
        second: coefficient(1),
        lags: (0..poles_per_m.len()).map(|lag| coefficient(2 + lag)).collect(),
        poles_per_m: poles_per_m.to_vec(),
        steady,
    }
}

/// Coefficients of p, p² (if `second`) and p/(p + g) by (real parts, imaginary parts) of the data.
fn solver(kappa: &[f64], poles: &[f64], second: bool) -> Mat<f64> {
    let n = kappa.len();
    let highest = kappa.iter().copied().fold(f64::MIN_POSITIVE, f64::max);
    let powers = 1 + usize::from(second);
    let function = |row: usize, column: usize| {
        let (k, imaginary) = (kappa[row % n], row >= n);
        match (column, imaginary) {
            (0, true) => k,
            (0, false) => 0.0,
            (1, true) if second => 0.0,
            (1, false) if second => -k * k,
            // i k/(i k + g) = (k² + i k g)/(k² + g²)
            (lag, _) => {
                let g = poles[lag - powers];
                k * if imaginary { g } else { k } / (k * k + g * g)
            }
        }
    };
    let weight = |row: usize| 1.0 / (KNEE + kappa[row % n] / highest);
    let unknowns = powers + poles.len();
    let weighted = Mat::from_fn(2 * n, unknowns, |r, c| weight(r) * function(r, c));
    let size: Vec<f64> = (0..unknowns).map(|c| norm(weighted.col(c).as_mat())).collect();
    let scaled = Mat::from_fn(2 * n, unknowns, |r, c| weighted[(r, c)] / size[c]);
    let weights = Mat::from_fn(2 * n, 2 * n, |r, c| if r == c { weight(r) } else { 0.0 });
    let solution = scaled.qr().solve_lstsq(weights);
    Mat::from_fn(unknowns, 2 * n, |r, c| solution[(r, c)] / size[r])
}

fn norm(column: MatRef<'_, f64>) -> f64 {
    (0..column.nrows()).map(|i| column[(i, 0)] * column[(i, 0)]).sum::<f64>().sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;
    use faer::c64;

    #[test]
    fn a_rational_function_of_its_own_form_is_found_again() {
        let (kappa, poles) = (vec![0.3, 0.8, 1.7, 3.0, 6.0, 9.0], vec![0.5, 2.0]);
        let of = |p: c64, second: f64| {
            c64::new(1.5, 0.0) + p * 0.7 + p * p * second - p / (p + 0.5) * 0.4 + p / (p + 2.0) * 0.1
        };
        let cp = kappa
            .iter()
            .map(|k| {
                let p = c64::new(0.0, *k);
                Mat::from_fn(1, 2, |_, column| of(p, if column == 0 { 0.2 } else { 0.0 }))
            })
            .collect();
        let table = AirTable { omega_over_v_per_m: kappa, cp };
        let air = fit(&table, Mat::from_fn(1, 2, |_, _| 1.5), &poles, |column| column == 1);
        for column in 0..2 {
            let second = if column == 0 { 0.2 } else { 0.0 };
            let found = [
                air.rate[(0, column)],
                air.second[(0, column)],
                air.lags[0][(0, column)],
                air.lags[1][(0, column)],
            ];
            for (value, wanted) in found.into_iter().zip([0.7, second, -0.4, 0.1]) {
                assert!((value - wanted).abs() < 1e-10, "{value} {wanted}");
            }
        }
    }
}
