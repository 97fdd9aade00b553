//! Eigenvalues of unsymmetric matrices, by QR steps without early deflation.
//!
//! From 75 rows on faer's own way (0.24) orders the eigenvalues of a deflation window by exchanging neighbouring blocks until no pair is
//! out of order. Where the first of a pair is a block of two (a swing) and rounding turns the exchange back, its window does not
//! shrink and it never ends: the state matrix of a calibrated wing did so. Single QR steps need no such order.

use faer::diag::Diag;
use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::evd::{ComputeEigenvectors, EvdParams, evd_real, evd_scratch};
use faer::{Mat, MatRef, Spec, c64, get_global_parallelism};

/// Eigenvalues; none if they do not converge.
pub fn eigenvalues(a: MatRef<'_, f64>) -> Option<Vec<c64>> {
    solved(a, ComputeEigenvectors::No).map(|(values, _)| values)
}

/// Eigenvalues and, by columns, eigenvectors; none if they do not converge.
pub fn eigen(a: MatRef<'_, f64>) -> Option<(Vec<c64>, Mat<c64>)> {
    let (values, real) = solved(a, ComputeEigenvectors::Yes)?;
    let n = values.len();
    let mut vectors = Mat::zeros(n, n);
    // a pair of conjugates has its real and imaginary part in two columns
    let mut k = 0;
    while k < n {
        let is_pair = values[k].im != 0.0 && k + 1 < n;
        for i in 0..n {
            if is_pair {
                vectors[(i, k)] = c64::new(real[(i, k)], real[(i, k + 1)]);
                vectors[(i, k + 1)] = c64::new(real[(i, k)], -real[(i, k + 1)]);
            } else {
                vectors[(i, k)] = c64::new(real[(i, k)], 0.0);
            }
        }
        k += if is_pair { 2 } else { 1 };
    }
    Some((values, vectors))
}

fn solved(a: MatRef<'_, f64>, vectors: ComputeEigenvectors) -> Option<(Vec<c64>, Mat<f64>)> {
    let (n, parallel) = (a.nrows(), get_global_parallelism());
    let mut params = Spec::<EvdParams, f64>::default();
    params.config.schur.blocking_threshold = usize::MAX;
    let (mut re, mut im, mut right) = (Diag::zeros(n), Diag::zeros(n), Mat::zeros(n, n));
    let asked = matches!(vectors, ComputeEigenvectors::Yes).then_some(right.as_mut());
    let needed = evd_scratch::<f64>(n, ComputeEigenvectors::No, vectors, parallel, params);
    let mut memory = MemBuffer::new(needed);
    let stack = MemStack::new(&mut memory);
    evd_real(a, re.as_mut(), im.as_mut(), None, asked, parallel, stack, params).ok()?;
    Some(((0..n).map(|k| c64::new(re[k], im[k])).collect(), right))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Lightly damped pairs and lags, turned by reflections: what a state matrix is like; its eigenvalues are known.
    fn turned(pairs: usize, lags: usize, seed: u64) -> (Mat<f64>, Vec<c64>) {
        let n = 2 * pairs + lags;
        let mut state = seed;
        let mut next = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 33) as f64 / f64::from(1_u32 << 31)
        };
        let (mut a, mut expected) = (Mat::zeros(n, n), Vec::new());
        for k in 0..pairs {
            let (decay, omega) = (0.02 + next(), 1.0 + 100.0 * next());
            (a[(2 * k, 2 * k + 1)], a[(2 * k + 1, 2 * k)]) = (omega, -omega);
            (a[(2 * k, 2 * k)], a[(2 * k + 1, 2 * k + 1)]) = (-decay, -decay);
            expected.extend([c64::new(-decay, omega), c64::new(-decay, -omega)]);
        }
        for k in 2 * pairs..n {
            a[(k, k)] = -1.0 - 50.0 * next();
            expected.push(c64::new(a[(k, k)], 0.0));
        }
        for _ in 0..3 {
            let v = Mat::from_fn(n, 1, |_, _| next() - 0.5);
            let twice_over = 2.0 / v.squared_norm_l2();
            let along = v.transpose() * &a;
            a -= (&v * along) * faer::Scale(twice_over);
            let along = &a * &v;
            a -= (along * v.transpose()) * faer::Scale(twice_over);
        }
        (a, expected)
    }

    #[test]
    fn eigenvalues_of_turned_blocks_are_the_blocks_and_vectors_belong_to_them() {
        for (pairs, lags, seed) in [(1, 0, 1), (0, 3, 2), (3, 2, 3), (20, 60, 4), (60, 40, 5)] {
            let (a, expected) = turned(pairs, lags, seed);
            let (values, vectors) = eigen(a.as_ref()).expect("they converge");
            let alone = eigenvalues(a.as_ref()).expect("they converge");
            for value in expected {
                let near = |all: &[c64]| {
                    all.iter().map(|other| (*other - value).norm()).fold(f64::INFINITY, f64::min)
                };
                assert!(near(&values) < 1e-9 * 100.0 && near(&alone) < 1e-9 * 100.0, "{value}");
            }
            let n = values.len();
            for (k, value) in values.iter().enumerate() {
                let size = (0..n).map(|i| vectors[(i, k)].norm_sqr()).sum::<f64>().sqrt();
                let off = |i: usize| {
                    let row: c64 = (0..n).map(|j| vectors[(j, k)] * a[(i, j)]).sum();
                    (row - *value * vectors[(i, k)]).norm()
                };
                let worst = (0..n).map(off).fold(0.0, f64::max);
                assert!(size > 0.1 && worst < 1e-8 * size, "{value}: {worst}");
            }
        }
    }
}
