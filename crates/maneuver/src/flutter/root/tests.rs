//! Roots that are known, and what a root is measured by.

use super::super::FormulaForces;
use super::*;

const PLACE: Place = Place { flow: Flow { v_m_s: 8.0, rho_kg_m3: 1.25 }, share: 0.5 };

fn coupled() -> FormulaForces<fn(f64) -> Mat<c64>> {
    let formula: fn(f64) -> Mat<c64> = |k| {
        Mat::from_fn(2, 2, |i, j| {
            c64::new([[0.3, 0.8], [-0.5, 0.4]][i][j] + 0.2 * k * k, -k * (0.6 + 0.3 * i as f64 * k))
        })
    };
    FormulaForces { size: 2, range: (0.0, 50.0), formula }
}

fn determinant(m: &Mat<c64>) -> c64 {
    m[(0, 0)] * m[(1, 1)] - m[(0, 1)] * m[(1, 0)]
}

#[test]
fn newton_s_method_ends_on_a_root_with_its_shape_and_on_its_own_frequency() {
    let air = coupled();
    let mass = Mat::from_fn(2, 2, |i, j| [[2.0, 0.2], [0.2, 1.0]][i][j]);
    let stiffness = Mat::from_fn(2, 2, |i, j| [[200.0, 5.0], [5.0, 300.0]][i][j]);
    let system = Aeroelastic::new(mass, Mat::zeros(2, 2), stiffness, &air).expect("two coordinates");
    for (start, u) in [(10.0, [1.0, 0.0]), (17.3, [0.0, 1.0])] {
        let guess =
            State { p: c64::new(0.0, start), u: u.map(c64::from).to_vec(), real: false, beyond: true };
        let root = system.root(&guess, PLACE).expect("a root near");
        let forces = system.split(root.p.im / 8.0, 8.0).expect("inside");
        let matrix = system.matrix(root.p, &forces, PLACE.flow, PLACE.share);
        assert!(determinant(&matrix).norm() < 1e-9 * matrix.norm_max() * 100.0, "{:?}", root.p);
        for i in 0..2 {
            assert!((0..2).map(|j| matrix[(i, j)] * root.u[j]).sum::<c64>().norm() < 1e-7);
        }
        assert!((system.product(&root.u, &root.u).norm() - 1.0).abs() < 1e-9 && !root.beyond && !root.real);
    }
}

#[test]
fn what_newton_s_method_needs_are_the_equation_s_derivatives() {
    let air = coupled();
    let system = Aeroelastic::of_modes(&[9.0, 14.0], 0.03, &air).expect("two modes");
    let (p, kappa) = (c64::new(-0.4, 11.0), 1.4);
    let at = |p: c64, kappa: f64| {
        let forces = system.split(kappa, 8.0).expect("inside");
        system.matrix(p, &forces, PLACE.flow, PLACE.share)
    };
    let point = system.point(p, kappa, false, PLACE).expect("inside");
    let h = 1e-4;
    let by_p = (at(p + h, kappa) - at(p - h, kappa)) * faer::Scale(c64::from(0.5 / h));
    let by_kappa = (at(p, kappa + h) - at(p, kappa - h)) * faer::Scale(c64::from(0.5 / h));
    assert!((&point.matrix - at(p, kappa)).norm_max() < 1e-12);
    assert!((&point.slope - by_p).norm_max() < 1e-7 && (&point.by_kappa - by_kappa).norm_max() < 1e-4);
    assert!(!point.beyond && point.by_kappa.norm_max() > 1.0);
    assert_eq!(system.point(p, kappa, true, PLACE).expect("inside").by_kappa.norm_max(), 0.0);
    assert!(system.point(p, 51.0, false, PLACE).expect("held").beyond);
}

#[test]
fn likeness_is_one_for_one_shape_and_weighs_with_the_mass() {
    let air = coupled();
    let mass = Mat::from_fn(2, 2, |i, j| if i == j { [4.0, 1.0][i] } else { 0.0 });
    let system = Aeroelastic::new(mass, Mat::zeros(2, 2), Mat::identity(2, 2), &air).expect("two");
    let (a, b) = ([c64::new(1.0, 1.0), c64::new(0.0, 2.0)], [c64::from(1.0), c64::from(1.0)]);
    // conj(1 + i) 4 + conj(2 i) = 4 - 6 i; sizes 12 and 5
    assert!((system.product(&a, &b) - c64::new(4.0, -6.0)).norm() < 1e-12);
    assert!((system.likeness(&a, &b) - 52.0 / 60.0).abs() < 1e-12);
    assert!((system.likeness(&a, &a.map(|x| x * c64::new(0.0, 3.0))) - 1.0).abs() < 1e-12);
    assert_eq!(system.likeness(&a, &[c64::default(); 2]), 0.0);
    let mut u = a.to_vec();
    system.normalise(&mut u);
    assert!((u[1] - c64::new(0.0, 2.0 / 12.0_f64.sqrt())).norm() < 1e-12);
    let mut none = vec![c64::default(); 2];
    system.normalise(&mut none);
    assert_eq!(none, [c64::default(); 2]);
}

#[test]
fn a_frequency_that_goes_to_zero_and_a_start_far_away_give_no_root() {
    let formula = |_: f64| Mat::from_fn(1, 1, |_, _| c64::from(1.0));
    let air = FormulaForces { size: 1, range: (0.0, 50.0), formula };
    // p² + 10 - 20: its roots do not oscillate
    let system = Aeroelastic::of_modes(&[10.0_f64.sqrt()], 0.0, &air).expect("one mode");
    let guess = |p: c64, real: bool| State { p, u: vec![c64::from(1.0)], real, beyond: false };
    assert!(system.root(&guess(c64::new(0.0, 3.0), false), PLACE).is_err());
    assert!(matches!(system.root(&guess(c64::from(-1.0), false), PLACE), Err(Missed::Collapsed)));
    let real = system.root(&guess(c64::from(2.0), true), PLACE).expect("a real root");
    assert!((real.p - c64::from(10.0_f64.sqrt())).norm() < 1e-10 && real.real, "{:?}", real.p);
}
