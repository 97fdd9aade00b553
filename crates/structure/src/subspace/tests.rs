//! Residuals of shapes.

use super::*;
use crate::factor::analysed;
use crate::sparse::{Pattern, Sparse};
use nalgebra::DMatrix;
use std::sync::Arc;

/// A chain of masses; its first one on a spring to the ground if it is held.
struct Chain {
    k: Sparse,
    m: Sparse,
}

const N: usize = 7;

impl Chain {
    fn new(is_held: bool) -> Self {
        let lists: Vec<Vec<usize>> = (0..N - 1).map(|at| vec![at, at + 1]).collect();
        let mut values = Pattern::of(N, &lists).values();
        for at in 0..N - 1 {
            let spring = 2.0 + at as f64;
            let k = DMatrix::from_row_slice(2, 2, &[spring, -spring, -spring, spring]);
            let m = DMatrix::from_row_slice(2, 2, &[1.0, 0.2, 0.2, 1.5]);
            values.add(&[at, at + 1], Some(&k), Some(&m));
        }
        values.add_entry(0, 0, [if is_held { 3.0 } else { 0.0 }, 0.0]);
        let (k, m) = values.symmetric();
        Self { k, m }
    }

    fn dense(a: &Sparse) -> DMatrix<f64> {
        let mut all = DMatrix::zeros(N, N);
        for j in 0..N {
            a.row_idx_of_col(j).zip(a.val_of_col(j)).for_each(|(i, value)| all[(i, j)] = *value);
        }
        all
    }

    /// Eigenvalues ascending and M-orthonormal shapes, by the dense problem.
    fn modes(&self) -> Ritz {
        let (k, m) = (Self::dense(&self.k), Self::dense(&self.m));
        let lower = m.cholesky().expect("masses are positive").l().try_inverse().expect("regular");
        let eigen = (&lower * k * lower.transpose()).symmetric_eigen();
        let mut order: Vec<usize> = (0..N).collect();
        order.sort_by(|a, b| eigen.eigenvalues[*a].total_cmp(&eigen.eigenvalues[*b]));
        let shapes = lower.transpose() * eigen.eigenvectors;
        let values = order.iter().map(|at| eigen.eigenvalues[*at]).collect();
        Ritz { values, vectors: Mat::from_fn(N, N, |i, j| shapes[(i, order[j])]) }
    }

    fn factor(&self, shift: f64) -> Factor {
        let values = sparse::combine(self.k.as_ref(), shift, self.m.as_ref());
        let a = SparseColMatRef::new(self.k.symbolic(), &values);
        Factor::held(&Arc::new(analysed(a.symbolic())), a)
    }
}

/// (lambda' + s) (K + s M)^-1 M x - x = ((lambda' + s) / (lambda + s) - 1) x for a mode x, of the M-norm one.
#[test]
fn a_mode_with_a_wrong_value_misses_by_its_relative_error() {
    let chain = Chain::new(true);
    for shift in [0.0, 1.5] {
        let (factor, none) = (chain.factor(shift), Rigid::none(N));
        let inverse = Inverse { factor: &factor, shift, rigid: &none };
        let mut ritz = chain.modes();
        let wrong = [1.0, 1.01, 0.9, 2.0, 1.0, 0.5];
        let expected: Vec<f64> = ritz
            .values
            .iter()
            .zip(wrong)
            .map(|(value, wrong)| ((value * wrong + shift) / (value + shift) - 1.0).abs())
            .collect();
        ritz.values.iter_mut().zip(wrong).for_each(|(value, wrong)| *value *= wrong);
        let own = residuals(chain.m.as_ref(), &inverse, &ritz, 6);
        assert_eq!(own.len(), 6);
        for (own, expected) in own.iter().zip(&expected) {
            assert!((own - expected).abs() < 1e-12, "shift {shift}: {own} for {expected}");
        }
    }
}

#[test]
fn rigid_motions_of_a_free_chain_are_left_out_and_its_modes_miss_nothing() {
    let chain = Chain::new(false);
    let factor = chain.factor(0.0);
    let rigid = Rigid::of(chain.m.as_ref(), &factor).expect("it has mass");
    assert_eq!(rigid.count(), 1);
    // All masses alike, of the M-norm one: the total is 6 (1 + 1.5 + 0.4).
    let each = (6.0_f64 * 2.9).sqrt().recip();
    assert!((0..N).all(|at| (rigid.motions[(at, 0)].abs() - each).abs() < 1e-12));
    let inverse = Inverse { factor: &factor, shift: 0.0, rigid: &rigid };
    let modes = chain.modes();
    let own = residuals(chain.m.as_ref(), &inverse, &modes, 4);
    assert_eq!(own.len(), 3, "the rigid one is no matter");
    assert!(own.iter().all(|own| *own < 1e-10), "{own:?}");
    assert!(residuals(chain.m.as_ref(), &inverse, &modes, 1).is_empty());
    let none = SparseColMatRef::new(chain.k.symbolic(), &[0.0; 3 * N - 2]);
    assert!(Rigid::of(none, &factor).is_none());
}

#[track_caller]
fn near(own: &[f64], expected: &[f64], within: f64) {
    assert_eq!(own.len(), expected.len());
    for (own, expected) in own.iter().zip(expected) {
        assert!((own - expected).abs() < within, "{own} for {expected}");
    }
}

#[test]
fn a_sweep_over_the_whole_space_finds_all_modes() {
    for (is_held, shift) in [(true, 0.0), (true, 0.7), (false, 0.0), (false, 0.5)] {
        let chain = Chain::new(is_held);
        let factor = chain.factor(shift);
        let rigid =
            if shift == 0.0 { Rigid::of(chain.m.as_ref(), &factor).expect("mass") } else { Rigid::none(N) };
        let inverse = Inverse { factor: &factor, shift, rigid: &rigid };
        let start = crate::blocks::Noise::new().extend(Mat::zeros(N, 0).as_ref(), 4);
        let ritz = sweep(chain.k.as_ref(), chain.m.as_ref(), &inverse, start.as_ref()).expect("it converges");
        near(&ritz.values, &chain.modes().values, 1e-9);
        let gram =
            inner(ritz.vectors.as_ref(), sparse::multiply(chain.m.as_ref(), ritz.vectors.as_ref()).as_ref());
        for (i, j) in (0..N).flat_map(|i| (0..N).map(move |j| (i, j))) {
            assert!((gram[(i, j)] - f64::from(u8::from(i == j))).abs() < 1e-10, "M-orthonormal: {i} {j}");
        }
    }
}

/// In the space of some modes, mixed and scaled, one more step takes them apart again.
#[test]
fn a_block_that_spans_modes_is_refined_to_them() {
    for (is_held, shift) in [(true, 0.0), (true, 0.7), (false, 0.0)] {
        let chain = Chain::new(is_held);
        let (factor, modes) = (chain.factor(shift), chain.modes());
        let rigid =
            if is_held { Rigid::none(N) } else { Rigid::of(chain.m.as_ref(), &factor).expect("mass") };
        let first = rigid.count();
        let inverse = Inverse { factor: &factor, shift, rigid: &rigid };
        let (cos, sin) = (0.8, 0.6);
        let mixed = Mat::from_fn(N, 4, |i, j| {
            let of = |mode: usize| modes.vectors[(i, mode)];
            match j {
                1 => cos * of(1) + sin * of(2),
                2 => cos * of(2) - sin * of(1),
                other => of(other),
            }
        });
        let ritz = Ritz { values: modes.values[..4].to_vec(), vectors: mixed };
        let (refined, misses) = refined(chain.m.as_ref(), &inverse, &ritz, 4).expect("they are apart");
        // A step takes the part of the other mode by the ratio of their eigenvalues.
        let ratio = (modes.values[1] + shift) / (modes.values[2] + shift);
        let own = &misses[1 - first..3 - first];
        near(own, &[sin * (1.0 - ratio), sin * (1.0 / ratio - 1.0)], 1e-9);
        assert!(misses[3 - first] < 1e-7, "a mode misses nothing: {misses:?}");
        near(&refined.values[first..], &modes.values[first..4], 1e-10);
        let all = refined.vectors.as_ref();
        let gram = inner(all, sparse::multiply(chain.m.as_ref(), all).as_ref());
        let stiff = inner(all, sparse::multiply(chain.k.as_ref(), all).as_ref());
        for (i, j) in (0..4).flat_map(|i| (0..4).map(move |j| (i, j))).filter(|(i, j)| i != j) {
            assert!(gram[(i, j)].abs() < 1e-10 && stiff[(i, j)].abs() < 1e-9, "{i} {j}");
        }
        assert!(
            super::refined(chain.m.as_ref(), &inverse, &ritz, first).is_none(),
            "nothing but rigid motions"
        );
    }
}

#[test]
fn a_basis_takes_what_is_new_and_has_mass() {
    let chain = Chain::new(true);
    let mut space = Space::new(chain.m.as_ref(), &Rigid::none(N), 4);
    // The third column is a combination, the fourth a tiny one of its own.
    let column = |i: usize, j: usize| match j {
        0 => 1.0 + i as f64,
        1 => (i as f64).sin(),
        2 => 2.0 * (1.0 + i as f64) - (i as f64).sin(),
        _ => 1e-9 * (i as f64).powi(2),
    };
    let mut columns = |x: Mat<f64>| space.extend(x).map(|new| new.columns);
    assert_eq!(columns(Mat::from_fn(N, 4, column)), Some(0..3));
    assert_eq!(
        columns(Mat::from_fn(N, 1, |i, _| 3.0 * (i as f64).powi(2) + 1e-3 * column(i, 1))),
        Some(3..3)
    );
    assert_eq!(columns(Mat::from_fn(N, 1, |i, _| f64::from(u8::from(i == 2)))), Some(3..4));
    let momenta = space.momenta(space.basis.as_ref());
    let gram = inner(space.basis.as_ref(), momenta.as_ref());
    for (i, j) in (0..4).flat_map(|i| (0..4).map(move |j| (i, j))) {
        assert!((gram[(i, j)] - f64::from(u8::from(i == j))).abs() < 1e-12, "{i} {j}");
    }
    let both = beside(space.basis.as_ref(), momenta.as_ref());
    assert_eq!((both.ncols(), both[(2, 3)], both[(2, 5)]), (8, space.basis[(2, 3)], momenta[(2, 1)]));
    assert_eq!(squares(both.as_ref().subcols(0, 2), both.as_ref().subcols(0, 2)).len(), 2);
}
