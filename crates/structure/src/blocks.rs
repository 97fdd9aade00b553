//! Blocks of vectors: noise to start with, and products that do not depend on the number of cores.

use faer::linalg::matmul::matmul;
use faer::{Accum, Mat, MatRef, Par};

/// Numbers between -1 and 1 from a fixed seed (Marsaglia's xorshift with a final multiplication): the same start
/// on every machine, and without any symmetry of the structure.
#[derive(Debug)]
pub(crate) struct Noise(u64);

impl Noise {
    pub(crate) fn new() -> Self {
        Self(0x9E37_79B9_7F4A_7C15)
    }

    fn next(&mut self) -> f64 {
        self.0 ^= self.0 >> 12;
        self.0 ^= self.0 << 25;
        self.0 ^= self.0 >> 27;
        let bits = self.0.wrapping_mul(0x2545_F491_4F6C_DD1D) >> 32;
        2.0 * (bits as f64) / f64::from(u32::MAX) - 1.0
    }

    /// `kept` and `more` further columns of noise.
    pub(crate) fn extend(&mut self, kept: MatRef<'_, f64>, more: usize) -> Mat<f64> {
        let mut block = Mat::zeros(kept.nrows(), kept.ncols() + more);
        for j in 0..block.ncols() {
            for i in 0..block.nrows() {
                block[(i, j)] = if j < kept.ncols() { kept[(i, j)] } else { self.next() };
            }
        }
        block
    }
}

/// A^T B on one thread: the sum must not depend on the number of cores.
pub(crate) fn inner(a: MatRef<'_, f64>, b: MatRef<'_, f64>) -> Mat<f64> {
    let mut product = Mat::zeros(a.ncols(), b.ncols());
    matmul(product.as_mut(), Accum::Replace, a.transpose(), b, 1.0, Par::Seq);
    product
}

/// A B on one thread.
pub(crate) fn product(a: MatRef<'_, f64>, b: MatRef<'_, f64>) -> Mat<f64> {
    let mut product = Mat::zeros(a.nrows(), b.ncols());
    matmul(product.as_mut(), Accum::Replace, a, b, 1.0, Par::Seq);
    product
}

#[cfg(test)]
mod tests;
