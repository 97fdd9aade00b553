//! Influences that are known in closed form, and what solving with them must give back.

#![expect(clippy::unwrap_used, reason = "a helper of tests may fail the test where it stands")]

use aero::{AeroError, DlmSettings, DoubletLattice, Lattice, MirrorPlane, Seams, SteadyAero};
use aero::{influence, influence_of_moved};
use faer::{Mat, c64};
use std::f64::consts::PI;

const NONE: MirrorPlane = MirrorPlane::None;

fn wing() -> Lattice {
    Lattice::trapezoid(1, [0.0, 0.1, 0.0], 0.5, [0.4, 1.5, 0.2], 0.3, [3, 4]).unwrap()
}

/// A wing and a tail behind it, whose strips stand in line with nothing.
fn with_tail() -> Lattice {
    let tail = Lattice::trapezoid(101, [1.5, 0.15, 0.3], 0.3, [1.6, 0.8, 0.25], 0.2, [2, 2]).unwrap();
    wing().joined(&tail).unwrap()
}

fn numbers(n: usize, seed: f64) -> Vec<f64> {
    (0..n).map(|i| 0.2 + (seed + 1.7 * i as f64).sin()).collect()
}

fn assert_near(got: &[f64], want: &[f64], relative: f64) {
    assert_eq!(got.len(), want.len());
    let size = want.iter().fold(0.0, |size: f64, value| size.max(value.abs()));
    assert!(got.iter().zip(want).all(|(a, b)| (a - b).abs() <= relative * size), "{got:?} {want:?}");
}

/// A horseshoe of width b whose bound line lies half a chord c ahead of the point (Katz and Plotkin, section
/// 10.4.5): with d from the point to the line's ends, 4 pi w/Gamma = b/((c/2) d) + (4/b) (1 + (c/2)/d), Gamma
/// = V cp c/2; x over beta first.
#[test]
fn a_single_box_needs_the_incidence_of_its_horseshoe() {
    for (chord, width) in [(1.0, 1.0), (0.3, 2.0), (2.0, 0.4)] {
        let one =
            Lattice::trapezoid(1, [0.7, -0.2, 0.1], chord, [0.7, width - 0.2, 0.1], chord, [1, 1]).unwrap();
        for mach in [0.0, 0.6] {
            let beta = f64::sqrt(1.0 - mach * mach);
            let ahead = chord / 2.0 / beta;
            let d = ahead.hypot(width / 2.0);
            let want = chord / 2.0 / (4.0 * PI) * (width / (ahead * d) + 4.0 / width * (1.0 + ahead / d));
            let got = influence(&one, NONE, mach).unwrap()[(0, 0)];
            assert!(
                (got / want - 1.0).abs() < 1e-13,
                "{chord} by {width} at {mach}: {got} instead of {want}"
            );
        }
    }
}

/// A strip without ends carries 2 pi/beta per rad (Prandtl and Glauert), with any number of boxes along the chord.
#[test]
fn a_very_wide_plate_carries_two_pi_over_beta() {
    for chordwise in [1, 4] {
        let plate =
            Lattice::trapezoid(1, [0.0, -1e5, 0.0], 1.0, [0.0, 1e5, 0.0], 1.0, [chordwise, 1]).unwrap();
        for mach in [0.0, 0.3, 0.8] {
            let cp = SteadyAero::new(&plate, NONE, mach).unwrap().pressures_of(&vec![1.0; plate.len()]);
            let lift = cp.iter().sum::<f64>() / f64::from(chordwise);
            let want = 2.0 * PI / f64::sqrt(1.0 - mach * mach);
            assert!(
                (lift / want - 1.0).abs() < 1e-4,
                "{chordwise} boxes at {mach}: {lift} instead of {want}"
            );
        }
    }
}

#[test]
fn pressures_need_the_incidences_that_they_were_solved_for() {
    let lattice = with_tail();
    let (n, w) = (lattice.len(), numbers(lattice.len(), 0.3));
    for plane in [NONE, MirrorPlane::Symmetric { y_m: 0.0 }, MirrorPlane::Antisymmetric { y_m: -0.4 }] {
        let a = influence(&lattice, plane, 0.4).unwrap();
        let steady = SteadyAero::new(&lattice, plane, 0.4).unwrap();
        let of =
            |cp: &[f64]| -> Vec<f64> { (0..n).map(|i| (0..n).map(|j| a[(i, j)] * cp[j]).sum()).collect() };
        assert_near(&of(&steady.pressures_of(&w)), &w, 1e-12);
        let both = Mat::from_fn(n, 2, |i, column| if column == 0 { w[i] } else { w[n - 1 - i] });
        let cp = steady.pressures(both.as_ref());
        for column in 0..2 {
            assert_near(&of(cp.col_as_slice(column)), both.col_as_slice(column), 1e-12);
        }
        let aero = DoubletLattice::new(&lattice, plane, 0.4, &DlmSettings::default()).unwrap();
        let (a, w) = (aero.influence(1.3).unwrap(), Mat::from_fn(n, 1, |i, _| c64::new(w[i], w[n - 1 - i])));
        let cp = aero.at(1.3).unwrap().pressures(w.as_ref());
        assert!((&a * &cp - &w).norm_max() < 1e-12 * w.norm_max());
    }
}

/// c . A^-1 w = (A^-T c) . w for any c and w.
#[test]
fn a_weighted_sum_of_pressures_weighs_incidences_by_the_transposed_solution() {
    let lattice = with_tail();
    let steady = SteadyAero::new(&lattice, MirrorPlane::Symmetric { y_m: 0.0 }, 0.3).unwrap();
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    for seed in [0.0, 1.0, 2.0] {
        let (c, w) = (numbers(lattice.len(), seed), numbers(lattice.len(), seed + 0.4));
        let weights = steady.weights_of_incidences(&c);
        assert_eq!(weights.len(), lattice.len());
        let (one, other) = (dot(&weights, &w), dot(&c, &steady.pressures_of(&w)));
        assert!((one - other).abs() < 1e-12 * (1.0 + one.abs()), "{one} {other}");
    }
}

/// Legs along the sides of strips are legs along the stream where the sides lie along it.
#[test]
fn boxes_that_nobody_has_moved_have_the_influence_of_the_lattice() {
    let lattice = with_tail();
    for plane in [NONE, MirrorPlane::Symmetric { y_m: 0.1 }, MirrorPlane::Antisymmetric { y_m: -0.3 }] {
        let seams = Seams::of(&lattice, plane);
        for mach in [0.0, 0.7] {
            let want = influence(&lattice, plane, mach).unwrap();
            let got = influence_of_moved(&lattice, &seams, plane, mach).unwrap();
            assert!((&got - &want).norm_max() < 1e-11 * want.norm_max(), "{plane:?} Mach {mach}");
        }
        assert_eq!(influence_of_moved(&lattice, &seams, plane, 1.0), Err(AeroError::Mach { mach: 1.0 }));
    }
}

#[test]
fn without_frequency_the_matrix_is_that_of_the_vortices_to_the_last_bit() {
    let lattice = with_tail();
    for plane in [NONE, MirrorPlane::Symmetric { y_m: 0.0 }] {
        let steady = influence(&lattice, plane, 0.5).unwrap();
        let aero = DoubletLattice::new(&lattice, plane, 0.5, &DlmSettings::default()).unwrap();
        let matrix = aero.influence(0.0).unwrap();
        let want = Mat::from_fn(lattice.len(), lattice.len(), |i, j| c64::from(steady[(i, j)]));
        assert_eq!(matrix, want, "{plane:?}");
    }
}
