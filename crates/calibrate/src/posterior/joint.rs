//! Airspeeds together: corrections of one are like those of another, and the structure, what surfaces do and dead weights are the same.
//!
//! The unknowns `z_k` of airspeed `k` are standard Gaussians before the data, with the correlation `R_kl` between airspeeds: one of structure
//! and surfaces and of what readings are off by, `exp(-|ln V_k/V_l| / alike)` of corrections (a process without memory in the logarithm of the
//! airspeed), none of sensors' own unknowns. With all rows `J` over their noise and what they ask for `d`, `w = (J R J' + I)⁻¹ d`:
//!
//! ```text
//! mean z_k = sum_l R_kl J_l' w_l,   cov z_k = I - S' (J R J' + I)⁻¹ S,   S_l = J_l R_lk
//! ```
//! (Rasmussen and Williams, Gaussian Processes for Machine Learning, 2006, Eqs. 2.23 and 2.24.)

use faer::linalg::solvers::{Llt, Solve};
use faer::{Mat, MatRef, Side};

/// Rows of an airspeed's data over their noise: by unknowns of the wing, then of the sensors.
pub(super) struct OfAirspeed<'a> {
    pub(super) v_m_s: f64,
    pub(super) rows: &'a [Vec<f64>],
    /// Which of them were read under a dead weight.
    pub(super) hung: Vec<bool>,
}

/// See the module.
pub(super) struct Joint {
    /// Airspeed, row of its data, and the row.
    rows: Vec<(usize, usize, Vec<f64>)>,
    /// Correlation of corrections between airspeeds; of the rest of a wing it is one where this is not zero.
    alike: Mat<f64>,
    /// Unknowns of corrections, of a wing in all, and with those of readings.
    corrections: usize,
    count: usize,
    shared: usize,
    /// With those of sensors, by airspeed.
    unknowns: Vec<usize>,
    /// Of `J R J' + I`.
    factor: Option<Llt<f64>>,
}

impl Joint {
    /// Of airspeeds that are alike over so much in their logarithm (0: each for itself), with so many unknowns of corrections, of a wing in
    /// all, and with those of readings.
    pub(super) fn new(of: &[OfAirspeed<'_>], [corrections, count, shared]: [usize; 3], alike: f64) -> Self {
        let between = |k: usize, l: usize| {
            let apart = (of[k].v_m_s / of[l].v_m_s).ln().abs();
            match alike {
                _ if k == l => 1.0,
                0.0 => 0.0,
                _ => (-apart / alike).exp(),
            }
        };
        let each = of.iter().enumerate().flat_map(|(k, at)| {
            // the same dead weight says nothing new at another airspeed, unless no airspeed knows of another
            let new = move |i: &usize| k == 0 || alike == 0.0 || !at.hung[*i];
            (0..at.rows.len()).filter(new).map(move |i| (k, i, at.rows[i].clone()))
        });
        let mut joint = Self {
            rows: each.collect(),
            alike: Mat::from_fn(of.len(), of.len(), between),
            corrections,
            count,
            shared,
            unknowns: of.iter().map(|at| at.rows.first().map_or(count, Vec::len)).collect(),
            factor: None,
        };
        joint.factor = joint.factorised(&joint.rows);
        joint
    }

    fn factorised(&self, rows: &[(usize, usize, Vec<f64>)]) -> Option<Llt<f64>> {
        let gram = |i: usize, j: usize| {
            let ((k, _, a), (l, _, b)) = (&rows[i], &rows[j]);
            self.product(*k, a, *l, b) + f64::from(u8::from(i == j))
        };
        let mut matrix = Mat::zeros(rows.len(), rows.len());
        for i in 0..rows.len() {
            for j in 0..=i {
                matrix[(i, j)] = gram(i, j);
            }
        }
        matrix.llt(Side::Lower).ok()
    }

    /// `a' R_kl b`.
    fn product(&self, k: usize, a: &[f64], l: usize, b: &[f64]) -> f64 {
        if k == l {
            return product(a, b);
        }
        let alike = self.alike[(k, l)];
        if alike == 0.0 {
            return 0.0;
        }
        let part =
            |from: usize, to: usize| -> f64 { a.iter().zip(b).take(to).skip(from).map(|(a, b)| a * b).sum() };
        alike * part(0, self.corrections) + part(self.corrections, self.shared)
    }

    /// The unknowns of every airspeed that the data and the prior leave most likely; `asked` is what a row of an airspeed's data asks for.
    pub(super) fn means(&self, asked: &dyn Fn(usize, usize) -> f64) -> Option<Vec<Vec<f64>>> {
        let right = Mat::from_fn(self.rows.len(), 1, |r, _| asked(self.rows[r].0, self.rows[r].1));
        let weights = self.factor.as_ref()?.solve(&right);
        let mut means: Vec<Vec<f64>> = self.unknowns.iter().map(|count| vec![0.0; *count]).collect();
        for (r, (l, _, row)) in self.rows.iter().enumerate() {
            for (k, mean) in means.iter_mut().enumerate() {
                for (i, mean) in mean.iter_mut().enumerate().take(row.len()) {
                    *mean += self.correlation(k, *l, i) * row[i] * weights[(r, 0)];
                }
            }
        }
        Some(means)
    }

    /// Of an unknown between two airspeeds.
    fn correlation(&self, k: usize, l: usize, unknown: usize) -> f64 {
        match self.alike[(k, l)] {
            _ if k == l => 1.0,
            alike if unknown < self.corrections => alike,
            alike => f64::from(u8::from(unknown < self.shared && alike > 0.0)),
        }
    }

    /// Standard deviation of what has this gradient at airspeed `k`.
    pub(super) fn sigma(&self, k: usize, gradient: &[f64]) -> f64 {
        self.sigma_by(&self.rows, self.factor.as_ref(), k, gradient)
    }

    /// The same with further rows at that airspeed beside the data.
    pub(super) fn sigma_with(&self, k: usize, further: &[Vec<f64>], gradient: &[f64]) -> f64 {
        let further = further.iter().enumerate().map(|(i, row)| (k, i, row.clone()));
        let rows: Vec<_> = self.rows.iter().cloned().chain(further).collect();
        self.sigma_by(&rows, self.factorised(&rows).as_ref(), k, gradient)
    }

    fn sigma_by(
        &self,
        rows: &[(usize, usize, Vec<f64>)],
        factor: Option<&Llt<f64>>,
        k: usize,
        gradient: &[f64],
    ) -> f64 {
        let seen = Mat::from_fn(rows.len(), 1, |r, _| self.product(rows[r].0, &rows[r].2, k, gradient));
        let told = factor.map_or(0.0, |factor| inner(seen.as_ref(), factor.solve(&seen).as_ref()));
        (product(gradient, gradient) - told).max(0.0).sqrt()
    }

    /// Symmetric root of the covariance of the wing's unknowns at airspeed `k`, whatever the sensors' are.
    pub(super) fn root(&self, k: usize) -> Mat<f64> {
        let mut covariance = Mat::<f64>::identity(self.count, self.count);
        if let Some(factor) = &self.factor {
            let seen = Mat::from_fn(self.rows.len(), self.count, |r, i| {
                let (l, _, row) = &self.rows[r];
                self.correlation(k, *l, i) * row.get(i).copied().unwrap_or(0.0)
            });
            covariance -= seen.transpose() * factor.solve(&seen);
        }
        let Ok(eigen) = covariance.self_adjoint_eigen(Side::Lower) else { return covariance };
        let roots: Vec<f64> = (0..self.count).map(|i| eigen.S()[i].max(0.0).sqrt()).collect();
        let scaled = Mat::from_fn(self.count, self.count, |i, j| eigen.U()[(i, j)] * roots[j]);
        scaled * eigen.U().transpose()
    }
}

fn inner(a: MatRef<'_, f64>, b: MatRef<'_, f64>) -> f64 {
    (0..a.nrows()).map(|i| a[(i, 0)] * b[(i, 0)]).sum()
}

/// The sum of products; what one of them does not list is zero.
pub(super) fn product(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

#[cfg(test)]
mod tests;
