//! The limit at rest, and what slow and near mean.

use super::super::FormulaForces;
use super::*;

fn diagonal(values: &[f64]) -> Mat<f64> {
    Mat::from_fn(values.len(), values.len(), |i, j| if i == j { values[i] } else { 0.0 })
}

fn nothing(size: usize) -> FormulaForces<impl Fn(f64) -> Mat<c64>> {
    FormulaForces { size, range: (0.0, 1.0), formula: move |_| Mat::zeros(size, size) }
}

#[test]
fn below_a_millionth_of_the_table_forces_are_those_at_rest() {
    // at rest 5, moving 7, as no air does
    let formula =
        |k: f64| Mat::from_fn(1, 1, |_, _| c64::new(if k == 0.0 { 5.0 } else { 7.0 }, 3.0 * k + k * k));
    let forces = FormulaForces { size: 1, range: (0.0, 2.0), formula };
    let system = Aeroelastic::of_modes(&[1.0], 0.0, &forces).expect("one mode");
    for (kappa, real, damping) in [
        (0.0, 5.0, 3.000_002),
        (1e-6, 5.0, 3.000_002),
        (2e-6, 7.0, 3.000_002),
        (1.0, 7.0, 4.0),
        (2.0, 7.0, 5.0),
    ] {
        let split = system.split(kappa, 10.0).expect("inside");
        assert_eq!((split.real[(0, 0)], split.beyond), (real, false), "{kappa}");
        assert!((split.damping[(0, 0)] - damping).abs() < 1e-9, "{kappa}: {}", split.damping[(0, 0)]);
    }
    // those of the end
    let beyond = system.split(4.0, 10.0).expect("held");
    assert_eq!((beyond.real[(0, 0)], beyond.damping[(0, 0)], beyond.beyond), (7.0, 5.0, true));
}

#[test]
fn the_slowest_mode_is_the_slowest_that_has_a_stiffness() {
    let slowest = |mass: &[f64], stiffness: &[f64]| {
        let forces = nothing(mass.len());
        let zero = Mat::zeros(mass.len(), mass.len());
        let system = Aeroelastic::new(diagonal(mass), zero, diagonal(stiffness), &forces).expect("modes");
        let slowest = system.slowest_rad_s();
        assert!((system.at_rest_rad_s() - 1e-3 * slowest).abs() < 1e-12 * slowest);
        assert_eq!(system.modulus(c64::new(3.0, -4.0) * slowest), c64::new(3.0, -4.0).norm() * slowest);
        assert_eq!(system.modulus(c64::new(1e-4, 0.0) * slowest), system.at_rest_rad_s());
        slowest
    };
    for (mass, stiffness, wanted) in [
        (&[4.0, 1.0][..], &[100.0, 49.0][..], 5.0),
        (&[1.0, 2.0], &[0.0, 98.0], 7.0),
        (&[1.0, 1.0], &[-4.0, 9.0], 3.0),
        (&[1.0, 1.0], &[0.0, 0.0], 1.0),
        // less than a thousand millionth of the largest is round-off
        (&[1.0, 1.0], &[1e6, 9e-4], 1e3),
        (&[1.0, 1.0], &[1e6, 1.6e-3], 0.04),
    ] {
        let found = slowest(mass, stiffness);
        assert!((found / wanted - 1.0).abs() < 1e-6, "{mass:?} {stiffness:?}: {found}");
    }
}
