//! Blocks of vectors: noise to start with, and products that do not depend on the number of cores.

use faer::linalg::matmul::matmul;
use faer::{Accum, Mat, MatRef, Par};
use rayon::prelude::*;

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

/// Rows that a thread works on at a time, always the same ones: sums do not depend on the number of threads.
const ROWS: usize = 8192;

/// Products of two numbers that are worth another thread: about a millisecond's.
const SHARED: usize = 4_000_000;

/// A^T B.
pub(crate) fn inner(a: MatRef<'_, f64>, b: MatRef<'_, f64>) -> Mat<f64> {
    let part = |start: usize| {
        let rows = ROWS.min(a.nrows() - start);
        let mut part = Mat::zeros(a.ncols(), b.ncols());
        let (a, b) = (a.subrows(start, rows), b.subrows(start, rows));
        matmul(part.as_mut(), Accum::Replace, a.transpose(), b, 1.0, Par::Seq);
        part
    };
    let starts: Vec<usize> = (0..a.nrows()).step_by(ROWS).collect();
    let is_shared = a.nrows() * a.ncols() * b.ncols() > SHARED;
    let parts: Vec<Mat<f64>> = if is_shared {
        starts.into_par_iter().map(part).collect()
    } else {
        starts.into_iter().map(part).collect()
    };
    parts.into_iter().reduce(|sum, part| sum + part).unwrap_or_else(|| Mat::zeros(a.ncols(), b.ncols()))
}

/// A B.
pub(crate) fn product(a: MatRef<'_, f64>, b: MatRef<'_, f64>) -> Mat<f64> {
    let mut product = Mat::zeros(a.nrows(), b.ncols());
    add_product(&mut product, 1.0, a, b);
    product
}

/// Adds so many times A B.
pub(crate) fn add_product(sum: &mut Mat<f64>, times: f64, a: MatRef<'_, f64>, b: MatRef<'_, f64>) {
    if a.nrows() * a.ncols() * b.ncols() <= SHARED {
        return matmul(sum.as_mut(), Accum::Add, a, b, times, Par::Seq);
    }
    let rows = sum.par_row_chunks_mut(ROWS).zip(a.par_row_chunks(ROWS));
    rows.for_each(|(sum, a)| matmul(sum, Accum::Add, a, b, times, Par::Seq));
}

#[cfg(test)]
mod tests;
