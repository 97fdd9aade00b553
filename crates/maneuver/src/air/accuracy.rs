//! How far a rational function is from the doublet lattice, entry by entry.

use super::rational::RationalAir;
use faer::{Mat, MatRef, c64};

/// Errors of every entry: largest difference over the entry's largest modulus at the frequencies looked at.
#[derive(Debug, Clone)]
pub struct Accuracy {
    /// Rows by motions, a share of one; zero for entries that are zero throughout.
    pub error: Mat<f64>,
}

impl Accuracy {
    /// Compares at frequencies omega/V (1/m): `exact` are the pressures there (boxes by motions), `rows` loads per unit
    /// pressure coefficient (rows by boxes). `largest` gives each entry's size, rows by motions.
    pub fn at(
        air: &RationalAir,
        samples: &[(f64, Mat<c64>)],
        rows: MatRef<'_, f64>,
        largest: MatRef<'_, f64>,
    ) -> Self {
        let mut error = Mat::<f64>::zeros(rows.nrows(), air.steady.ncols());
        for (kappa, exact) in samples {
            let difference = loads(rows, (exact - air.at(c64::new(0.0, *kappa))).as_ref());
            grow(&mut error, &difference);
        }
        let error = Mat::from_fn(error.nrows(), error.ncols(), |i, j| {
            if largest[(i, j)] > 0.0 { error[(i, j)] / largest[(i, j)] } else { 0.0 }
        });
        Self { error }
    }
}

/// Entries of a smaller share of their row's largest are rounding: loads that symmetry or a rigid part keeps at zero.
const ROUNDING: f64 = 1e-9;

/// The largest modulus of each entry of `rows` times the pressures, over all samples; zero for rounding.
pub fn largest<'a>(rows: MatRef<'_, f64>, samples: impl Iterator<Item = &'a Mat<c64>>) -> Mat<f64> {
    let mut size = Mat::zeros(0, 0);
    for cp in samples {
        let value = loads(rows, cp.as_ref());
        if size.nrows() == 0 {
            size = Mat::zeros(value.nrows(), value.ncols());
        }
        grow(&mut size, &value);
    }
    for i in 0..size.nrows() {
        let least = ROUNDING * size.row(i).iter().copied().fold(0.0, f64::max);
        for entry in size.row_mut(i).iter_mut().filter(|entry| **entry < least) {
            *entry = 0.0;
        }
    }
    size
}

fn grow(size: &mut Mat<f64>, value: &Mat<c64>) {
    for j in 0..value.ncols() {
        for i in 0..value.nrows() {
            size[(i, j)] = size[(i, j)].max(value[(i, j)].norm());
        }
    }
}

/// Real rows times complex columns.
fn loads(rows: MatRef<'_, f64>, cp: MatRef<'_, c64>) -> Mat<c64> {
    let part = |of: fn(c64) -> f64| Mat::from_fn(cp.nrows(), cp.ncols(), |i, j| of(cp[(i, j)]));
    let (re, im) = (rows * part(|z| z.re), rows * part(|z| z.im));
    Mat::from_fn(re.nrows(), re.ncols(), |i, j| c64::new(re[(i, j)], im[(i, j)]))
}

/// Largest error of each row.
pub fn worst_by_row(accuracy: &Accuracy) -> Vec<f64> {
    let error = &accuracy.error;
    (0..error.nrows()).map(|i| (0..error.ncols()).map(|j| error[(i, j)]).fold(0.0, f64::max)).collect()
}

/// Largest error of each motion.
pub fn worst_by_column(accuracy: &Accuracy) -> Vec<f64> {
    let error = &accuracy.error;
    (0..error.ncols()).map(|j| (0..error.nrows()).map(|i| error[(i, j)]).fold(0.0, f64::max)).collect()
}
