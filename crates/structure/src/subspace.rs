//! A block of vectors, M-orthonormal, and its Rayleigh-Ritz values: one sweep of subspace iteration.

use crate::factor::Factor;
use crate::sparse;
use faer::linalg::matmul::matmul;
use faer::sparse::SparseColMatRef;
use faer::{Accum, Mat, MatRef, Par, Side};

/// A direction that keeps less than this share of its length is in the space of those before it.
const DEPENDENT: f64 = 1e-12;

type SparseRef<'a> = SparseColMatRef<'a, usize, f64>;

/// Ritz pairs: values ascending, vectors M-orthonormal.
#[derive(Debug)]
pub(crate) struct Ritz {
    pub(crate) values: Vec<f64>,
    pub(crate) vectors: Mat<f64>,
}

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
fn product(a: MatRef<'_, f64>, b: MatRef<'_, f64>) -> Mat<f64> {
    let mut product = Mat::zeros(a.nrows(), b.ncols());
    matmul(product.as_mut(), Accum::Replace, a, b, 1.0, Par::Seq);
    product
}

/// One sweep: (K + s M)^-1 M x, orthonormalised, projected; `None` if the small problem does not converge.
pub(crate) fn sweep(k: SparseRef<'_>, m: SparseRef<'_>, factor: &Factor, x: MatRef<'_, f64>) -> Option<Ritz> {
    let basis = orthonormal(m, factor.solve(sparse::multiply(m, x).as_ref()).as_ref());
    let projected = inner(basis.as_ref(), sparse::multiply(k, basis.as_ref()).as_ref());
    let eigen = projected.self_adjoint_eigen(Side::Lower).ok()?;
    let values = eigen.S().column_vector().iter().copied().collect();
    Some(Ritz { values, vectors: product(basis.as_ref(), eigen.U()) })
}

/// Gram-Schmidt in the inner product of M, twice for each vector; dependent and massless vectors are left out.
fn orthonormal(m: SparseRef<'_>, x: MatRef<'_, f64>) -> Mat<f64> {
    let n = x.nrows();
    let mut basis = Mat::<f64>::zeros(n, x.ncols());
    let mut momenta = Mat::<f64>::zeros(n, x.ncols());
    let mut count = 0;
    for j in 0..x.ncols() {
        let mut v = x.subcols(j, 1).to_owned();
        let before = m_norm(m, &v);
        for _ in 0..2 {
            let share = inner(momenta.subcols(0, count), v.as_ref());
            matmul(v.as_mut(), Accum::Add, basis.subcols(0, count), share.as_ref(), -1.0, Par::Seq);
        }
        let momentum = sparse::multiply(m, v.as_ref());
        let norm = inner(v.as_ref(), momentum.as_ref())[(0, 0)].max(0.0).sqrt();
        if norm > DEPENDENT * before {
            for i in 0..n {
                basis[(i, count)] = v[(i, 0)] / norm;
                momenta[(i, count)] = momentum[(i, 0)] / norm;
            }
            count += 1;
        }
    }
    basis.subcols(0, count).to_owned()
}

fn m_norm(m: SparseRef<'_>, v: &Mat<f64>) -> f64 {
    inner(v.as_ref(), sparse::multiply(m, v.as_ref()).as_ref())[(0, 0)].max(0.0).sqrt()
}

/// How far each of the first `count` pairs is from being a mode: the M-norm of (lambda + s) (K + s M)^-1 M x - x.
/// Unlike K x - lambda M x this is not drowned by the round-off of the stiffest motions.
pub(crate) fn residuals(
    m: SparseRef<'_>,
    factor: &Factor,
    shift: f64,
    ritz: &Ritz,
    count: usize,
) -> Vec<f64> {
    let x = ritz.vectors.subcols(0, count);
    let image = factor.solve(sparse::multiply(m, x).as_ref());
    let factors = &ritz.values;
    let error = Mat::from_fn(x.nrows(), count, |i, j| (factors[j] + shift) * image[(i, j)] - x[(i, j)]);
    (0..count).map(|j| m_norm(m, &error.subcols(j, 1).to_owned())).collect()
}
