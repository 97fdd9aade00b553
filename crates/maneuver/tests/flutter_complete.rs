//! Laws of the complete list of p-k roots, and of the K method: on air without memory the roots are eigenvalues of a matrix.

#![allow(clippy::unwrap_used, reason = "a test whose data cannot be computed must fail")]

use aero::Flow;
use faer::{Mat, c64};
use maneuver::flutter::{Aeroelastic, FormulaForces};

const RHO: f64 = 1.225;
const DAMPING: f64 = 0.01;

fn speeds(low: f64, high: f64, count: u32) -> Vec<Flow> {
    let step = (high - low) / f64::from(count - 1);
    (0..count).map(|i| Flow { v_m_s: low + step * f64::from(i), rho_kg_m3: RHO }).collect()
}

const Q0: [[f64; 3]; 3] = [[0.02, 3.0, 0.3], [-0.4, 0.6, 0.2], [0.1, -0.3, 0.4]];
const Q1: [[f64; 3]; 3] = [[-1.0, -0.3, 0.1], [-0.2, -0.8, 0.1], [0.05, 0.1, -0.6]];

/// Q = q0 + i kappa q1, with a flutter and a divergence.
fn forces() -> FormulaForces<fn(f64) -> Mat<c64>> {
    let formula: fn(f64) -> Mat<c64> =
        |kappa| Mat::from_fn(3, 3, |i, j| c64::new(Q0[i][j], kappa * Q1[i][j]));
    FormulaForces { size: 3, range: (0.0, 1e4), formula }
}

/// Eigenvalues of the same as x' = A x that do not swing backwards.
fn eigenvalues(flow: Flow, omega: &[f64; 3]) -> Vec<c64> {
    let (q, v) = (flow.dynamic_pressure_pa(), flow.v_m_s);
    let spring = |i: usize, j: usize| if i == j { omega[j].powi(2) } else { 0.0 };
    let damper = |i: usize, j: usize| if i == j { 2.0 * DAMPING * omega[j] } else { 0.0 };
    let a = Mat::from_fn(6, 6, |i, j| match (i < 3, j < 3) {
        (true, _) => f64::from(u8::from(j == i + 3)),
        (false, true) => q * Q0[i - 3][j] - spring(i - 3, j),
        (false, false) => q / v * Q1[i - 3][j - 3] - damper(i - 3, j - 3),
    });
    a.eigenvalues().unwrap().into_iter().filter(|p| p.im >= 0.0).collect()
}

/// Every root at every flow is an eigenvalue, and every eigenvalue is a root.
fn assert_complete(omega: &[f64; 3], lowest_m_s: f64) {
    let air = forces();
    let system = Aeroelastic::of_modes(omega, DAMPING, &air).unwrap();
    let flows = speeds(lowest_m_s, 25.0, 33);
    let curves = system.pk_complete(&flows).unwrap();
    for (place, flow) in flows.iter().enumerate() {
        let wanted = eigenvalues(*flow, omega);
        let found: Vec<c64> = curves.branches.iter().filter_map(|b| b.at(place)).map(|root| root.p).collect();
        assert_eq!(found.len(), wanted.len(), "{} m/s: {found:?} for {wanted:?}", flow.v_m_s);
        for p in &wanted {
            let off = found.iter().map(|root| (root - p).norm()).fold(f64::INFINITY, f64::min);
            assert!(off < 1e-7 * p.norm(), "{} m/s: {p} is missing, off by {off:e}", flow.v_m_s);
        }
    }
}

#[test]
fn all_eigenvalues_are_roots_and_all_roots_are_eigenvalues() {
    assert_complete(&[10.0, 17.0, 40.0], 1.0);
}

#[test]
fn a_motion_without_stiffness_has_its_roots_too() {
    // Slower, a root is slower than a thousandth of the slowest mode with a stiffness, and left out.
    assert_complete(&[0.0, 17.0, 40.0], 4.0);
    assert_complete(&[0.0, 0.0, 40.0], 4.0);
}

#[test]
fn changes_of_stability_are_those_of_modes_followed_from_a_vacuum() {
    let air = forces();
    let system = Aeroelastic::of_modes(&[10.0, 17.0, 40.0], DAMPING, &air).unwrap();
    let flows = speeds(1.0, 25.0, 33);
    let (complete, followed) = (system.pk_complete(&flows).unwrap(), system.pk(&flows).unwrap());
    assert!(complete.begun_unstable.is_empty(), "{:?}", complete.begun_unstable);
    let [a, b] = [complete.flutter().unwrap(), followed.flutter().unwrap()];
    assert!((a.flow.v_m_s / b.flow.v_m_s - 1.0).abs() < 1e-9, "{a:?} {b:?}");
    assert!((a.omega_rad_s / b.omega_rad_s - 1.0).abs() < 1e-9, "{a:?} {b:?}");
}

#[test]
fn the_k_method_finds_the_flutter_of_pk_without_structural_damping() {
    let air = forces();
    let system = Aeroelastic::of_modes(&[10.0, 17.0, 40.0], DAMPING, &air).unwrap();
    let flutter = *system.pk_complete(&speeds(1.0, 25.0, 33)).unwrap().flutter().unwrap();
    let v = flutter.flow.v_m_s;
    let at = |kappa: f64| {
        let roots = system.k_roots(kappa, RHO).unwrap();
        roots.into_iter().min_by(|a, b| (a.v_m_s - v).abs().total_cmp(&(b.v_m_s - v).abs())).unwrap()
    };
    let root = at(flutter.omega_rad_s / v);
    assert!((root.v_m_s / v - 1.0).abs() < 1e-8, "{root:?} {flutter:?}");
    assert!(root.g.abs() < 1e-8, "{root:?}");
    assert!((root.omega_rad_s / flutter.omega_rad_s - 1.0).abs() < 1e-8, "{root:?} {flutter:?}");
    // Slower and faster: of the two sides one needs damping and the other has too much.
    let [slower, faster] = [at(1.05 * flutter.omega_rad_s / v), at(0.95 * flutter.omega_rad_s / v)];
    assert!(slower.g * faster.g < 0.0, "{slower:?} {faster:?}");
}
