//! What a run may be off by without any effect, taken out of its residual.

use crate::shared::product;
use faer::linalg::matmul::matmul;
use faer::reborrow::ReborrowMut;
use faer::{Accum, ColMut, Mat, Par, Side};

/// Orthonormal directions and what of them is left.
#[derive(Debug, Clone)]
pub(crate) struct Tolerance {
    pub(crate) rows: std::ops::Range<usize>,
    directions: Mat<f64>,
    taken: Vec<f64>,
}

impl Tolerance {
    /// `(I + L L')^(-1/2) = I - U diag(1 - 1/sqrt(1 + s²)) U'`, L the columns.
    pub(crate) fn new(rows: std::ops::Range<usize>, columns: &[Vec<f64>]) -> Self {
        let columns = Mat::from_fn(rows.len(), columns.len(), |row, k| columns[k][row]);
        let gram = product(columns.transpose(), columns.as_ref());
        let Ok(eigen) = gram.self_adjoint_eigen(Side::Lower) else {
            return Self { directions: Mat::zeros(rows.len(), 0), taken: Vec::new(), rows };
        };
        let kept: Vec<usize> = (0..columns.ncols()).filter(|j| eigen.S()[*j] > 1e-8).collect();
        let of = |i: usize, j: usize| eigen.U()[(i, kept[j])] / eigen.S()[kept[j]].sqrt();
        let shares = Mat::from_fn(columns.ncols(), kept.len(), of);
        let directions = product(columns.as_ref(), shares.as_ref());
        let taken = kept.iter().map(|j| 1.0 - 1.0 / (1.0 + eigen.S()[*j]).sqrt()).collect();
        Self { rows, directions, taken }
    }

    /// Takes the directions out of the values of the segment they belong to.
    pub(crate) fn free(&self, own: &mut [f64]) {
        let mut part = ColMut::from_slice_mut(&mut own[self.rows.clone()]).as_mat_mut();
        let mut shares = product(self.directions.transpose(), part.as_ref());
        for (j, taken) in self.taken.iter().enumerate() {
            shares[(j, 0)] *= taken;
        }
        matmul(part.rb_mut(), Accum::Add, self.directions.as_ref(), shares.as_ref(), -1.0, Par::Seq);
    }
}
