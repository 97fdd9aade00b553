//! Rational functions with common poles (Roger 1977): `cp(p) = c_0 + c_1 p + c_2 p² + sum_j d_j p/(p + g_j)`.
//!
//! `c_0` is the steady answer, so the function is exact at p = 0. With the poles g given, everything else is linear
//! least squares with the same weights for all entries: the approximation of a sum of rows is the sum of the
//! approximations, and factors that multiply the rows (corrections, areas, mode shapes) may be applied after it.
//! All g are positive: no lag can grow.

use super::basis::Basis;
use super::table::AirTable;
use faer::{Mat, Scale, c64};

/// See the module. Matrices are boxes (or whatever the rows are) by motions.
#[derive(Debug, Clone)]
pub struct RationalAir {
    /// g, 1/m: lags die away over the distance 1/g.
    pub poles_per_m: Vec<f64>,
    /// `c_0`.
    pub steady: Mat<f64>,
    /// `c_1`, m.
    pub rate: Mat<f64>,
    /// `c_2`, m².
    pub second: Mat<f64>,
    /// `d`, one matrix a pole.
    pub lags: Vec<Mat<f64>>,
}

/// What the frequencies of a table count in a fit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Weighting {
    /// Errors count alike far below this share of the table's highest frequency, and the less above it the higher the
    /// frequency.
    pub knee: f64,
}

impl Weighting {
    /// Of a wing on its balance: up to two fifths of the table, where ailerons and the first modes are.
    pub const RIG: Self = Self { knee: 0.4 };
    /// Of an aircraft in flight, whose wake on the tail no real pole imitates: slow motions, where maneuvers are.
    pub const FLIGHT: Self = Self { knee: 0.05 };
}

impl RationalAir {
    /// Air without memory.
    pub fn quasi_steady(steady: Mat<f64>, rate: Mat<f64>) -> Self {
        let second = Mat::zeros(steady.nrows(), steady.ncols());
        Self { poles_per_m: Vec::new(), steady, rate, second, lags: Vec::new() }
    }

    /// Air that is right at p = i `omega_over_v` alone (1/m, positive), where its pressures are `cp`.
    pub fn frozen(cp: &Mat<c64>, omega_over_v: f64) -> Self {
        let steady = Mat::from_fn(cp.nrows(), cp.ncols(), |i, j| cp[(i, j)].re);
        let rate = Mat::from_fn(cp.nrows(), cp.ncols(), |i, j| cp[(i, j)].im / omega_over_v);
        Self::quasi_steady(steady, rate)
    }

    /// The least squares fit of a table with given poles (1/m) and steady answer. Motions of which `is_incidence` is true have
    /// no term in p²: they enter by an incidence, so that their apparent mass is `c_1` and p² would be the derivative of an
    /// acceleration.
    pub fn fit(
        table: &AirTable,
        steady: Mat<f64>,
        poles_per_m: &[f64],
        weighting: Weighting,
        is_incidence: impl Fn(usize) -> bool,
    ) -> Self {
        let kappa = &table.omega_over_v_per_m;
        let basis = |second| Basis::new(kappa, poles_per_m, weighting.knee, second);
        let bases = [basis(true), basis(false)];
        let n = table.cp.len();
        let coefficient = |function: usize| {
            Mat::from_fn(steady.nrows(), steady.ncols(), |j, column| {
                let without_second = is_incidence(column);
                // without p² the list of functions is one shorter
                let row = match (without_second, function) {
                    (true, 1) => return 0.0,
                    (true, lag) if lag > 1 => lag - 1,
                    _ => function,
                };
                let solver = &bases[usize::from(without_second)].solver;
                let mut sum = 0.0;
                for (k, cp) in table.cp.iter().enumerate() {
                    let value = cp[(j, column)];
                    sum +=
                        solver[(row, k)] * (value.re - steady[(j, column)]) + solver[(row, n + k)] * value.im;
                }
                sum
            })
        };
        Self {
            rate: coefficient(0),
            second: coefficient(1),
            lags: (0..poles_per_m.len()).map(|lag| coefficient(2 + lag)).collect(),
            poles_per_m: poles_per_m.to_vec(),
            steady,
        }
    }

    /// The steady answer, damping and apparent mass alone.
    #[must_use]
    pub fn without_lags(self) -> Self {
        Self { poles_per_m: Vec::new(), lags: Vec::new(), ..self }
    }

    /// The function at p = s/V, 1/m.
    pub fn at(&self, p: c64) -> Mat<c64> {
        let complex = |part: &Mat<f64>, factor: c64| {
            Mat::from_fn(part.nrows(), part.ncols(), |i, j| factor * part[(i, j)])
        };
        let mut sum = complex(&self.steady, c64::new(1.0, 0.0));
        sum += complex(&self.rate, p) + complex(&self.second, p * p);
        for (lag, pole) in self.lags.iter().zip(&self.poles_per_m) {
            sum += complex(lag, p / (p + *pole));
        }
        sum
    }

    /// `rows` times the function: the same for loads, rows by boxes.
    #[must_use]
    pub fn mapped(&self, rows: &Mat<f64>) -> Self {
        Self {
            poles_per_m: self.poles_per_m.clone(),
            steady: rows * &self.steady,
            rate: rows * &self.rate,
            second: rows * &self.second,
            lags: self.lags.iter().map(|lag| rows * lag).collect(),
        }
    }

    /// The function times a number.
    #[must_use]
    pub fn scaled(&self, factor: f64) -> Self {
        let by = Scale(factor);
        Self {
            poles_per_m: self.poles_per_m.clone(),
            steady: by * &self.steady,
            rate: by * &self.rate,
            second: by * &self.second,
            lags: self.lags.iter().map(|lag| by * lag).collect(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

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
        for weighting in [Weighting::RIG, Weighting::FLIGHT] {
            let steady = Mat::from_fn(1, 2, |_, _| 1.5);
            let air = RationalAir::fit(&table, steady, &poles, weighting, |column| column == 1);
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
}
