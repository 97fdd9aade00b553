//! What all runs share: columns with unit normal amplitudes, and the inner product that they leave.

use faer::linalg::matmul::matmul;
use faer::linalg::solvers::Solve;
use faer::{Accum, ColRef, Mat, MatRef, Par, Side};

/// See the module.
#[derive(Debug, Clone)]
pub struct Shared {
    columns: Mat<f64>,
    inverse: Mat<f64>,
}

impl Shared {
    /// From the columns (each as long as the residual).
    pub fn new(columns: &[Vec<f64>], rows: usize) -> Self {
        let g = Mat::from_fn(rows, columns.len(), |i, j| columns[j][i]);
        let mut a = product(g.transpose(), g.as_ref());
        for j in 0..a.ncols() {
            a[(j, j)] += 1.0;
        }
        let inverse = match a.llt(Side::Lower) {
            Ok(factor) => factor.solve(Mat::identity(a.nrows(), a.nrows())),
            Err(_) => Mat::identity(a.nrows(), a.nrows()),
        };
        Self { columns: g, inverse }
    }

    /// A vector as long as the residual with what the columns see of it, `G' x`, behind it. Both are linear in it, so that what is made
    /// of such vectors needs no look at the columns any more, which take more time than all else.
    pub fn extended(&self, mut x: Vec<f64>) -> Vec<f64> {
        let own = ColRef::from_slice(&x).as_mat();
        let seen = product(self.columns.transpose(), own);
        x.extend(seen.col_as_slice(0));
        x
    }

    /// `X' (I + G G')⁻¹ X`.
    pub fn gram(&self, x: MatRef<'_, f64>) -> Mat<f64> {
        let plain = product(x.transpose(), x);
        let seen = product(self.columns.transpose(), x);
        plain - seen.transpose() * (&self.inverse * &seen)
    }

    /// The same of vectors that are [`Self::extended`].
    pub fn gram_of_extended(&self, x: MatRef<'_, f64>) -> Mat<f64> {
        let (own, seen) = x.split_at_row(self.columns.nrows());
        product(own.transpose(), own) - seen.transpose() * (&self.inverse * seen)
    }

    /// `x' (I + G G')⁻¹ x`.
    pub fn norm(&self, x: &[f64]) -> f64 {
        self.gram(ColRef::from_slice(x).as_mat())[(0, 0)]
    }

    /// The same of a vector that is [`Self::extended`].
    pub fn norm_of_extended(&self, x: &[f64]) -> f64 {
        self.gram_of_extended(ColRef::from_slice(x).as_mat())[(0, 0)]
    }

    /// The step that a linear model with unit normal amplitudes takes: `(I + J'J)⁻¹ (J'r - sizes)` in this inner product, from
    /// sizes in units of the plausible; columns of J and r are [`Self::extended`].
    pub fn step(&self, jacobian: &Mat<f64>, residual: &[f64], sizes: &[f64]) -> LinearStep {
        let k = jacobian.ncols();
        let stacked =
            Mat::from_fn(residual.len(), k + 1, |i, j| if j < k { jacobian[(i, j)] } else { residual[i] });
        let gram = self.gram_of_extended(stacked.as_ref());
        let mut normal = gram.submatrix(0, 0, k, k).to_owned();
        for j in 0..k {
            normal[(j, j)] += 1.0;
        }
        let right = Mat::from_fn(k, 1, |j, _| gram[(j, k)] - sizes[j]);
        let step = match normal.llt(Side::Lower) {
            Ok(factor) => factor.solve(&right),
            Err(_) => Mat::zeros(k, 1),
        };
        let gain = (0..k).map(|j| step[(j, 0)] * right[(j, 0)]).sum();
        LinearStep { step: (0..k).map(|j| step[(j, 0)]).collect(), gain, square: gram[(k, k)] }
    }

    /// `(I + G G')⁻¹ x`.
    pub fn weighted(&self, x: &[f64]) -> Vec<f64> {
        let column = Mat::from_fn(x.len(), 1, |i, _| x[i]);
        let seen = product(self.columns.transpose(), column.as_ref());
        let amplitude = &self.inverse * &seen;
        let mut weighted = x.to_vec();
        for j in 0..self.columns.ncols() {
            let by = amplitude[(j, 0)];
            weighted.iter_mut().zip(self.columns.col_as_slice(j)).for_each(|(w, g)| *w -= by * g);
        }
        weighted
    }
}

/// A step of the linear model.
#[derive(Debug, Clone, PartialEq)]
pub struct LinearStep {
    /// Change of the sizes.
    pub step: Vec<f64>,
    /// What chi square and prior fall by.
    pub gain: f64,
    /// `r' (I + G G')⁻¹ r` of the residual.
    pub square: f64,
}

/// `A B`, on one thread, so that the result does not depend on their number.
pub(crate) fn product(a: MatRef<'_, f64>, b: MatRef<'_, f64>) -> Mat<f64> {
    let mut product = Mat::zeros(a.nrows(), b.ncols());
    matmul(product.as_mut(), Accum::Replace, a, b, 1.0, Par::Seq);
    product
}

#[cfg(test)]
mod tests;
