//! Two coordinates by hand.

use super::super::FormulaForces;
use super::*;
use aero::Flow;

const PLACE: Place = Place { flow: Flow { v_m_s: 10.0, rho_kg_m3: 1.2 }, share: 1.0 };

fn forces() -> FormulaForces<fn(f64) -> Mat<c64>> {
    let formula: fn(f64) -> Mat<c64> = |k| {
        Mat::from_fn(2, 2, |i, j| {
            c64::from([[-0.4, 0.0], [0.0, 1.0]][i][j]) + c64::new(0.0, k) * [[-0.2, 0.0], [0.0, -0.1]][i][j]
        })
    };
    FormulaForces { size: 2, range: (0.0, 1e3), formula }
}

#[test]
fn frequencies_change_sign_between_two_values_of_kappa_where_they_cross_kappa_v() {
    let found = brackets(&(1.0, vec![30.0, 12.0, 5.0]), &(2.0, vec![31.0, 18.0]), 10.0);
    let said: Vec<(usize, bool)> = found.iter().map(|b| (b.rank, b.is_above)).collect();
    assert_eq!(said, [(1, true)]);
    assert_eq!(found[0].kappas, [1.0, 2.0]);
    // what is not there does not oscillate
    let found = brackets(&(0.5, vec![30.0, 4.0]), &(1.0, vec![9.0, 11.0, 12.0]), 10.0);
    let said: Vec<(usize, bool)> = found.iter().map(|b| (b.rank, b.is_above)).collect();
    assert_eq!(said, [(0, true), (1, false), (2, false)]);
    // exactly on the line is not above it
    assert_eq!(brackets(&(1.0, vec![10.0]), &(2.0, vec![20.5]), 10.0).len(), 1);
    assert!(brackets(&(1.0, vec![10.0]), &(2.0, vec![20.0]), 10.0).is_empty());
}

#[test]
fn with_forces_held_uncoupled_coordinates_have_the_roots_of_their_parabolas() {
    let air = forces();
    let mass = Mat::from_fn(2, 2, |i, j| if i == j { [2.0, 0.5][i] } else { 0.0 });
    let stiffness = Mat::from_fn(2, 2, |i, j| if i == j { [50.0, 40.0][i] } else { 0.0 });
    let damping = Mat::from_fn(2, 2, |i, j| if i == j { [0.3, 0.7][i] } else { 0.0 });
    let system = Aeroelastic::new(mass, damping, stiffness, &air).expect("two coordinates");
    // q = 60 Pa: 2 p² + (.3 + 1.2) p + 50 + 24 and .5 p² + (.7 + .6) p + 40 - 60
    let wanted = [
        c64::new(-0.375, (37.0_f64 - 0.375 * 0.375).sqrt()),
        c64::from(-1.3 + (1.69_f64 + 40.0).sqrt()),
        c64::from(-1.3 - (1.69_f64 + 40.0).sqrt()),
    ];
    let states = system.held_at(0.0, PLACE).expect("eigenvalues");
    assert_eq!(states.len(), 3);
    for p in wanted {
        let state = states.iter().find(|state| (state.p - p).norm() < 1e-9).expect("each root");
        assert_eq!((state.real, state.beyond), (p.im == 0.0, false));
        let (own, other) = if state.real { (1, 0) } else { (0, 1) };
        assert!(state.u[own].norm() > 1e3 * state.u[other].norm(), "{:?}", state.u);
    }
    assert!((states[0].p - wanted[0]).norm() < 1e-9, "the fastest first");
    let frequencies = system.frequencies_at(0.0, PLACE).expect("eigenvalues");
    assert!(frequencies.len() == 3 && (frequencies[0] - wanted[0].im).abs() < 1e-9);
    assert_eq!(frequencies[1..], [0.0, 0.0]);
    assert!((system.slowest_rad_s() - 5.0).abs() < 1e-9);
    let all = system.all_roots(PLACE, &[]).expect("all roots");
    let order: Vec<c64> = all.iter().map(|state| state.p).collect();
    for (found, wanted) in order.iter().zip([wanted[2], wanted[1], wanted[0]]) {
        assert!((found - wanted).norm() < 1e-8, "{order:?}");
    }
}

#[test]
fn a_rigid_motion_does_not_count_as_the_slowest_mode() {
    let air = forces();
    let free = Aeroelastic::of_modes(&[0.0, 7.0], 0.0, &air).expect("two");
    assert!((free.slowest_rad_s() - 7.0).abs() < 1e-9);
    let loose = Aeroelastic::of_modes(&[0.0, 0.0], 0.0, &air).expect("two");
    assert_eq!(loose.slowest_rad_s(), 1.0);
    assert!(is_real(c64::new(2.0, 1e-9)) && !is_real(c64::new(2.0, 1e-8)) && !is_real(c64::new(0.0, 1.0)));
    assert!(is_real(c64::default()) && is_real(c64::new(-2.0, -1e-9)));
}
