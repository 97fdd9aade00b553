//! Modes that have to satisfy their own equation, and chains whose frequencies are known.

use super::*;
use crate::factor::Factor;
use crate::model::Model;
use crate::modes::normal_modes;
use crate::sparse::multiply;
use crate::system::System;
use std::f64::consts::PI;
use std::fmt::Write as _;

fn system(deck: &str) -> System {
    let bulk = nastran::parse_deck("test.bdf", deck).expect("a deck");
    System::assemble(&Model::from_bulk(&bulk).expect("a model")).expect("a structure")
}

fn modes(system: &System) -> Ritz {
    let ritz = all_modes(system.stiffness(), system.mass()).expect("modes");
    assert!(ritz.values.is_sorted());
    ritz
}

/// How far shapes are from `X' M X = E`, and the largest `r' K⁻¹ r / λ` of `r = K x - λ M x`, as a root: what is missing of
/// a mode's strain energy.
fn misses(system: &System, ritz: &Ritz) -> [f64; 2] {
    let x = ritz.vectors.as_ref();
    let momenta = multiply(system.mass(), x);
    let unit = x.transpose() * &momenta;
    let right = (0..unit.nrows())
        .flat_map(|i| (0..unit.ncols()).map(move |j| (i, j)))
        .map(|(i, j)| (unit[(i, j)] - f64::from(u8::from(i == j))).abs())
        .fold(0.0, f64::max);
    let forces = multiply(system.stiffness(), x);
    let left = Mat::from_fn(x.nrows(), x.ncols(), |i, j| forces[(i, j)] - ritz.values[j] * momenta[(i, j)]);
    let answer = Factor::held(system.analysis(), system.stiffness()).solve(left.as_ref());
    let energy = |j: usize| {
        let work: f64 = (0..x.nrows()).map(|i| left[(i, j)] * answer[(i, j)]).sum();
        (work / ritz.values[j]).sqrt()
    };
    [right, (0..x.ncols()).map(energy).fold(0.0, f64::max)]
}

/// Squares of its frequencies span twelve decades: a slender wing of 36 short bars.
#[test]
fn every_mode_of_a_slender_wing_satisfies_its_equation() {
    let mut deck =
        String::from("MAT1,1,7.+10,2.7+10,,2700.\nPBAR,1,1,1.-4,4.-10,9.-8,2.-10\nSPC1,1,123456,1\nGRID,1\n");
    let mut y_m = 0.0;
    for grid in 2..=37 {
        y_m += if grid % 5 == 0 { 0.2 } else { 0.03 };
        let _ = writeln!(deck, "GRID,{grid},,0.,{y_m:.3},0.\nCBAR,{grid},1,{},{grid},0.,0.,1.", grid - 1);
        if grid % 9 == 0 {
            let _ = writeln!(deck, "CONM2,{},{grid},,.05", 100 + grid);
        }
    }
    let system = system(&deck);
    let ritz = modes(&system);
    assert_eq!(ritz.values.len(), system.free_count());
    let range = ritz.values[ritz.values.len() - 1] / ritz.values[0];
    let [right, energy] = misses(&system, &ritz);
    assert!(range > 1e12, "{range:e}");
    let all = normal_modes(&system, system.free_count()).expect("all of them").omega_rad_s;
    assert!(all.iter().zip(&ritz.values).all(|(omega, value)| (omega * omega / value - 1.0).abs() < 1e-14));
    assert!(right < 1e-12 && energy < 1e-7, "{right:e} {energy:e}");
}

/// `n` masses of 2 kg on springs of 50 N/m, the first tied to the ground and the last one free, with two grids without
/// mass between neighbours (each spring is three of 150 N/m): `ω = 2 √(k/m) sin((2 j - 1) π / (4 n + 2))`.
#[test]
fn motions_without_mass_follow_and_are_no_modes() {
    let n = 7;
    let mut deck = String::from("GRID,1\nSPC1,1,123456,1\n");
    for grid in 2..=3 * n + 1 {
        let _ = writeln!(
            deck,
            "GRID,{grid},,{grid}.,0.,0.\nSPC1,1,12456,{grid}\nCELAS2,{grid},150.,{},3,{grid},3",
            grid - 1
        );
        if grid % 3 == 1 {
            let _ = writeln!(deck, "CONM2,{},{grid},,2.", 100 + grid);
        }
    }
    let system = system(&deck);
    let ritz = modes(&system);
    assert_eq!((ritz.values.len(), system.free_count()), (n, 3 * n));
    for (j, value) in ritz.values.iter().enumerate() {
        let angle = (2 * j + 1) as f64 * PI / (4 * n + 2) as f64;
        let omega = 2.0 * 25_f64.sqrt() * angle.sin();
        assert!((value.sqrt() / omega - 1.0).abs() < 1e-13, "{j}: {} for {omega}", value.sqrt());
    }
    let [right, energy] = misses(&system, &ritz);
    assert!(right < 1e-13 && energy < 1e-12, "{right:e} {energy:e}");
}

/// A mass beside its grid: three of the grid's six motions have mass.
#[test]
fn a_mass_beside_its_grid_moves_it_in_three_ways() {
    let mut deck = String::from("GRID,1\nCONM2,9,1,,2.,.3,.2,-.1\n");
    for k in 1..=6 {
        let _ = writeln!(deck, "CELAS2,{k},{k}00.,1,{k}");
    }
    let system = system(&deck);
    let ritz = modes(&system);
    assert_eq!((ritz.values.len(), system.free_count()), (3, 6));
    let [right, energy] = misses(&system, &ritz);
    assert!(right < 1e-13 && energy < 1e-13, "{right:e} {energy:e}");
    // the flexibility at the mass, K = diag(100, 200, 300) and diag(400, 500, 600): F = K_t⁻¹ + B K_r⁻¹ B', u = ω x r
    let [x, y, z] = [0.3, 0.2, -0.1];
    let turned = [[0.0, z, -y], [-z, 0.0, x], [y, -x, 0.0]];
    let flexibility = Mat::<f64>::from_fn(3, 3, |i, j| {
        let moved = if i == j { 0.01 / (i + 1) as f64 } else { 0.0 };
        moved + (0..3).map(|k| turned[i][k] * turned[j][k] * 0.01 / (k + 4) as f64).sum::<f64>()
    });
    let own = flexibility.self_adjoint_eigenvalues(faer::Side::Lower).expect("three");
    for (value, flexible) in ritz.values.iter().rev().zip(own) {
        assert!((value * 2.0 * flexible - 1.0).abs() < 1e-13, "{value} {flexible}");
    }
}

#[test]
fn a_structure_that_nothing_holds_is_left_to_others() {
    let system = system(
        "GRID,1,,0.,0.,0.\nGRID,2,,1.,0.,0.\nSPC1,1,12456,1,2\nCELAS2,1,10.,1,3,2,3\nCONM2,8,1,,1.\nCONM2,9,2,,1.\n",
    );
    assert!(all_modes(system.stiffness(), system.mass()).is_none());
}
