//! The equation's parts by hand.

use super::super::FormulaForces;
use super::*;

fn forces() -> FormulaForces<fn(f64) -> Mat<c64>> {
    let formula: fn(f64) -> Mat<c64> = |k| {
        Mat::from_fn(2, 2, |i, j| {
            c64::new(1.0 + (i + 2 * j) as f64 + k * k, (2.0 + i as f64) * k + k * k * k)
        })
    };
    FormulaForces { size: 2, range: (0.0, 2.0), formula }
}

fn system(forces: &FormulaForces<fn(f64) -> Mat<c64>>) -> Aeroelastic<'_> {
    let of = |seed: f64| {
        Mat::from_fn(2, 2, |i, j| {
            (seed + 1.3 * i as f64 + 2.9 * j as f64).sin() + f64::from(u8::from(i == j)) * 3.0
        })
    };
    Aeroelastic::new(of(0.1), of(0.2), of(0.3), forces).expect("two by two")
}

#[test]
fn forces_split_into_those_in_phase_and_those_over_frequency() {
    let forces = forces();
    let system = system(&forces);
    for kappa in [0.0, 1e-7, 0.5, 2.0] {
        let split = system.split(kappa, 10.0).expect("inside");
        for (i, j) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
            assert!(
                (split.real[(i, j)] - (1.0 + (i + 2 * j) as f64 + kappa * kappa)).abs() < 1e-12,
                "{kappa}"
            );
            assert!((split.damping[(i, j)] - (2.0 + i as f64) - kappa * kappa).abs() < 1e-10, "{kappa}");
        }
        assert!(!split.beyond);
    }
    // beyond its end Re Q and Im Q/kappa of the table are held
    let beyond = system.split(3.0, 10.0).expect("held");
    assert!(beyond.beyond);
    assert!((beyond.real[(1, 0)] - 6.0).abs() < 1e-12 && (beyond.damping[(1, 0)] - 7.0).abs() < 1e-12);
}

#[test]
fn the_matrix_and_its_slope_are_the_equation_s() {
    let forces = forces();
    let system = system(&forces);
    let (flow, share, p) = (Flow { v_m_s: 10.0, rho_kg_m3: 1.2 }, 0.5, c64::new(-0.3, 2.0));
    let split = system.split(0.2, 10.0).expect("inside");
    let (matrix, slope) = (system.matrix(p, &split, flow, share), system.slope(p, &split, flow, share));
    for (i, j) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
        let q = 30.0;
        let rate = system.damping()[(i, j)] - q / 10.0 * split.damping[(i, j)];
        let wanted =
            p * p * system.mass()[(i, j)] + p * rate + system.stiffness()[(i, j)] - q * split.real[(i, j)];
        assert!((matrix[(i, j)] - wanted).norm() < 1e-12);
        assert!((slope[(i, j)] - (p * 2.0 * system.mass()[(i, j)] + rate)).norm() < 1e-12);
    }
}

#[test]
fn modes_of_mass_one_and_what_cannot_be_a_matrix() {
    let forces = forces();
    let modes = Aeroelastic::of_modes(&[3.0, 5.0], 0.1, &forces).expect("two modes");
    for (i, j, wanted) in
        [(0, 0, [1.0, 0.6, 9.0]), (1, 1, [1.0, 1.0, 25.0]), (0, 1, [0.0; 3]), (1, 0, [0.0; 3])]
    {
        let found = [modes.mass()[(i, j)], modes.damping()[(i, j)], modes.stiffness()[(i, j)]];
        assert!(found.iter().zip(wanted).all(|(a, b)| (a - b).abs() < 1e-12), "{found:?}");
    }
    assert_eq!((modes.size(), modes.forces().range()), (2, (0.0, 2.0)));
    let square = || Mat::<f64>::identity(2, 2);
    for (rows, columns) in [(2, 3), (3, 2), (1, 1)] {
        let error = Aeroelastic::new(square(), Mat::zeros(rows, columns), square(), &forces).err();
        assert!(matches!(error, Some(FlutterError::Size { what: "the damping", .. })), "{rows} by {columns}");
    }
    let infinite = Mat::from_fn(2, 2, |i, j| if (i, j) == (1, 0) { f64::INFINITY } else { 1.0 });
    let error = Aeroelastic::new(square(), square(), infinite, &forces).err();
    assert!(matches!(error, Some(FlutterError::Number { what: "the stiffness", .. })));
}
