//! What a run may be off by without any effect, taken out of its residual.

use faer::{Mat, Side};

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
        let k = columns.len();
        let dot = |i: usize, j: usize| columns[i].iter().zip(&columns[j]).map(|(a, b)| a * b).sum::<f64>();
        let gram = Mat::from_fn(k, k, dot);
        let mut directions = Vec::new();
        let mut taken = Vec::new();
        if let Ok(eigen) = gram.self_adjoint_eigen(Side::Lower) {
            for j in 0..k {
                let square = eigen.S()[j];
                if square > 1e-8 {
                    let scale = 1.0 / square.sqrt();
                    let direction: Vec<f64> = (0..rows.len())
                        .map(|row| scale * (0..k).map(|i| columns[i][row] * eigen.U()[(i, j)]).sum::<f64>())
                        .collect();
                    directions.push(direction);
                    taken.push(1.0 - 1.0 / (1.0 + square).sqrt());
                }
            }
        }
        let directions = Mat::from_fn(rows.len(), taken.len(), |row, j| directions[j][row]);
        Self { rows, directions, taken }
    }

    /// Takes the directions out of the values of the segment they belong to.
    pub(crate) fn free(&self, own: &mut [f64]) {
        let part = &mut own[self.rows.clone()];
        for (j, taken) in self.taken.iter().enumerate() {
            let direction = self.directions.col_as_slice(j);
            let share: f64 = direction.iter().zip(part.iter()).map(|(d, p)| d * p).sum();
            part.iter_mut().zip(direction).for_each(|(p, d)| *p -= taken * share * d);
        }
    }
}
