//! Block Lanczos on oscillators and chains whose frequencies have closed forms.

use super::*;
use crate::factor::{Factor, analysed};
use crate::sparse::{Pattern, Sparse};
use crate::subspace::Rigid;
use std::sync::Arc;

/// Stiffness and mass of oscillators that do not hang together.
fn oscillators(squares: &[f64]) -> (Sparse, Sparse) {
    let lists: Vec<Vec<usize>> = (0..squares.len()).map(|at| vec![at]).collect();
    let mut values = Pattern::of(squares.len(), &lists).values();
    for (at, square) in squares.iter().enumerate() {
        let mass = 1.0 + (at % 7) as f64;
        values.add_entry(at, at, [square * mass, mass]);
    }
    values.symmetric()
}

/// Equal masses in a row on equal springs, free at both ends.
fn free_chain(n: usize) -> (Sparse, Sparse) {
    let lists: Vec<Vec<usize>> = (0..n - 1).map(|at| vec![at, at + 1]).collect();
    let mut values = Pattern::of(n, &lists).values();
    for at in 0..n {
        let springs = if at == 0 || at == n - 1 { 1.0 } else { 2.0 };
        values.add_entry(at, at, [springs, 1.0]);
    }
    (0..n - 1).for_each(|at| values.add_entry(at + 1, at, [-1.0, 0.0]));
    values.symmetric()
}

struct Held {
    m: Sparse,
    factor: Factor,
    rigid: Rigid,
}

impl Held {
    fn of((k, m): (Sparse, Sparse)) -> Self {
        let factor = Factor::held(&Arc::new(analysed(k.symbolic())), k.as_ref());
        let rigid = Rigid::of(m.as_ref(), &factor).expect("rigid motions have mass");
        Self { m, factor, rigid }
    }

    fn lowest(&self, noise: &mut Noise, elastic: usize, known: &Ritz) -> Found {
        let inverse = Inverse { factor: &self.factor, shift: 0.0, rigid: &self.rigid };
        lowest(self.m.as_ref(), &inverse, noise, Asked { elastic, miss: 1e-7, known }).expect("it converges")
    }
}

fn nothing(n: usize) -> Ritz {
    Ritz { values: Vec::new(), vectors: Mat::zeros(n, 0) }
}

#[track_caller]
fn near(own: &[f64], expected: &[f64], within: f64) {
    for (at, (own, expected)) in own.iter().zip(expected).enumerate() {
        assert!((own / expected - 1.0).abs() < within, "{at}: {own} for {expected}");
    }
}

/// Too close together for one basis: it is begun again several times.
#[test]
fn close_frequencies_are_found_through_restarts() {
    let squares: Vec<f64> = (0..900).map(|at| 100.0 + f64::from((at * 541) % 900)).collect();
    let held = Held::of(oscillators(&squares));
    let found = held.lowest(&mut Noise::new(), 12, &nothing(900));
    let expected: Vec<f64> = (0..12).map(|at| 100.0 + f64::from(at)).collect();
    assert!(found.ritz.values.len() >= 12 && !found.is_complete);
    near(&found.ritz.values, &expected, 1e-12);
    for (j, square) in expected.iter().enumerate() {
        let own = squares.iter().position(|own| own == square).expect("one of them");
        let mass = 1.0 + (own % 7) as f64;
        let share = found.ritz.vectors[(own, j)].powi(2) * mass;
        assert!((share - 1.0).abs() < 1e-12, "mode {j} is one oscillator alone: {share}");
    }
}

/// omega = 2 sin(k pi / 2 n) for k = 0 to n - 1.
#[test]
fn modes_of_a_free_chain_come_after_its_rigid_motion() {
    let n = 300_u16;
    let held = Held::of(free_chain(usize::from(n)));
    let found = held.lowest(&mut Noise::new(), 9, &nothing(usize::from(n)));
    assert_eq!(found.ritz.values[0], 0.0);
    let square = |k: u16| (2.0 * (f64::from(k) * std::f64::consts::PI / (2.0 * f64::from(n))).sin()).powi(2);
    near(&found.ritz.values[1..], &(1..10).map(square).collect::<Vec<_>>(), 1e-9);
}

/// Thirteen copies of a frequency, more than a block has columns, of which nine are known: the others come from new noise.
#[test]
fn what_is_missing_comes_from_noise_beside_what_is_known() {
    let squares: Vec<f64> = (0..200).map(|at| if at < 13 { 4.0 } else { 9.0 + f64::from(at) }).collect();
    let held = Held::of(oscillators(&squares));
    let mut known = nothing(200);
    known.values = vec![4.0; 9];
    known.vectors =
        Mat::from_fn(200, 9, |i, j| if i == j { (1.0 + (i % 7) as f64).sqrt().recip() } else { 0.0 });
    let found = held.lowest(&mut Noise::new(), 15, &known);
    let expected: Vec<f64> = [vec![4.0; 13], vec![22.0, 23.0]].concat();
    near(&found.ritz.values[..15], &expected, 1e-9);
}

#[test]
fn of_a_few_motions_with_mass_all_are_found_and_no_others() {
    let (k, _) = free_chain(40);
    let mut values = Pattern::of(40, &[vec![0]]).values();
    for (at, mass) in [(3, 2.0), (20, 1.0), (39, 5.0)] {
        values.add_entry(at, at, [0.0, mass]);
    }
    let held = Held::of((k, values.symmetric().1));
    let found = held.lowest(&mut Noise::new(), 6, &nothing(40));
    assert!(found.is_complete);
    // Masses 2, 1 and 5 with springs of 1/17 and 1/19 between them: (sum of squares, product) = (trace, minor of M^-1 K).
    let (a, b) = (1.0 / 17.0, 1.0 / 19.0);
    let [_, low, high] = found.ritz.values[..] else { panic!("{:?}", found.ritz.values) };
    let trace = a / 2.0 + (a + b) + b / 5.0;
    let minors = a * b / 2.0 + a * b / 5.0 + a * b / 10.0;
    assert!(((low + high) / trace - 1.0).abs() < 1e-12 && (low * high / minors - 1.0).abs() < 1e-12);
}
