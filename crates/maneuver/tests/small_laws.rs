//! The K method, schedules of forces, gusts and curves of flutter in closed form, on one or two coordinates.

use aero::Flow;
use faer::{Mat, c64};
use maneuver::flutter::{
    Aeroelastic, FlutterError, FormulaForces, GafTable, GeneralisedForces, Root, ScheduledForces,
    first_divergence,
};
use maneuver::gust::{FrequencyTable, OneMinusCosineGust, elastic_response, periodic_response};
use std::f64::consts::TAU;

fn one(of: impl Fn(f64) -> c64) -> FormulaForces<impl Fn(f64) -> Mat<c64>> {
    FormulaForces {
        size: 2,
        range: (0.0, 10.0),
        formula: move |k| Mat::from_fn(2, 2, |i, j| if i == j { of(k) } else { c64::default() }),
    }
}

#[test]
fn uncoupled_oscillations_of_the_k_method_have_the_damping_that_their_air_takes() {
    let air = one(|k| c64::new(0.3 - k, -0.4 * k));
    let square = |values: [f64; 2]| Mat::from_fn(2, 2, |i, j| if i == j { values[i] } else { 0.0 });
    let system =
        Aeroelastic::new(square([2.0, 1.0]), square([0.0; 2]), square([72.0, 300.0]), &air).expect("two");
    let (kappa, rho) = (0.7, 1.2);
    let roots = system.k_roots(kappa, rho).expect("eigenvalues");
    assert_eq!(roots.len(), 2);
    for (root, (m, k)) in roots.iter().zip([(2.0, 72.0), (1.0, 300.0)]) {
        // kappa² m + rho/2 Q = k (1 + i g)/V²
        let inertia = kappa * kappa * m + 0.5 * rho * c64::new(0.3 - kappa, -0.4 * kappa);
        let v = (k / inertia.re).sqrt();
        assert!((root.v_m_s - v).abs() < 1e-9 && (root.omega_rad_s - kappa * v).abs() < 1e-9, "{root:?} {v}");
        assert!((root.g - inertia.im / inertia.re).abs() < 1e-9, "{root:?}");
    }
    // with a damper the equation itself
    let damped =
        Aeroelastic::new(square([2.0, 1.0]), square([3.0, 5.0]), square([72.0, 300.0]), &air).expect("two");
    for (root, (m, c, k)) in
        damped.k_roots(kappa, rho).expect("eigenvalues").iter().zip([(2.0, 3.0, 72.0), (1.0, 5.0, 300.0)])
    {
        let inertia = kappa * kappa * m + 0.5 * rho * c64::new(0.3 - kappa, -0.4 * kappa);
        let p = c64::new(0.0, root.v_m_s) / c64::new(1.0, root.g).sqrt();
        assert!((inertia * p * p + kappa * c * p + k).norm() < 1e-7 * k, "{root:?}");
    }
    assert!(system.k_roots(11.0, rho).is_err());
}

#[test]
fn schedules_refuse_airspeeds_that_do_not_rise_and_tables_of_another_size() {
    let table = |n: usize, value: f64| {
        GafTable::new(vec![0.0, 2.0], vec![Mat::from_fn(n, n, |_, _| c64::from(value)); 2]).expect("a table")
    };
    for speeds in [[10.0, 10.0], [20.0, 10.0]] {
        let error = ScheduledForces::new(speeds.map(|v| (v, table(1, 1.0))).to_vec()).expect_err("no rise");
        assert!(matches!(error, FlutterError::Number { value, .. } if value == speeds[1]), "{error}");
    }
    let error = ScheduledForces::new(vec![(1.0, table(1, 1.0)), (2.0, table(2, 1.0))]).expect_err("sizes");
    assert!(matches!(error, FlutterError::Size { rows: 2, columns: 2, expected: 1, .. }), "{error}");
    let sets = [(10.0, 1.0), (20.0, 4.0), (40.0, 2.0)].map(|(v, f)| (v, table(2, f))).to_vec();
    let forces = ScheduledForces::new(sets).expect("rising");
    assert_eq!((forces.size(), forces.range()), (2, (0.0, 2.0)));
    for (v, wanted) in [
        (5.0, 1.0),
        (14.0, 1.0 + 3.0 * 96.0 / 300.0),
        (20.0, 4.0),
        (30.0, 4.0 - 2.0 * 500.0 / 1200.0),
        (50.0, 2.0),
    ] {
        assert!((forces.at(1.0, v).expect("inside")[(1, 0)] - c64::from(wanted)).norm() < 1e-12, "{v}");
    }
}

#[test]
fn a_structure_in_its_air_answers_oscillating_loads_as_a_complex_spring() {
    let air = one(|k| c64::new(0.2, -0.5 * k));
    let system = Aeroelastic::of_modes(&[5.0, 9.0], 0.04, &air).expect("two modes");
    let (flow, omega, g) = (Flow { v_m_s: 10.0, rho_kg_m3: 1.2 }, 6.0, 0.03);
    let loads = Mat::from_fn(2, 1, |i, _| c64::new(1.0, i as f64));
    let structural = Mat::from_fn(2, 2, |i, j| g * system.stiffness()[(i, j)]);
    let x = elastic_response(&system, flow, omega, structural.as_ref(), loads.as_ref()).expect("inside");
    for (i, w) in [5.0, 9.0].into_iter().enumerate() {
        let spring = c64::new(w * w - 36.0 - 60.0 * 0.2, g * w * w + 0.08 * w * omega + 60.0 * 0.5 * 0.6);
        assert!((x[(i, 0)] - loads[(i, 0)] / spring).norm() < 1e-12);
    }
    assert!(elastic_response(&system, flow, 101.0, structural.as_ref(), loads.as_ref()).is_err());
}

#[test]
fn a_gust_is_half_high_at_its_quarters_and_nothing_outside() {
    let gust = OneMinusCosineGust { incidence_rad: 0.08, length_m: 20.0, start_s: 0.5 };
    // at 10 m/s it lasts two seconds
    for (t, wanted) in [(0.4, 0.0), (0.5, 0.0), (1.0, 0.04), (1.5, 0.08), (2.0, 0.04), (2.5, 0.0), (3.5, 0.0)]
    {
        assert!((gust.at(t, 10.0) - wanted).abs() < 1e-12, "{t}");
    }
    assert!((gust.at(0.5 + 1.0 / 3.0, 10.0) - 0.02).abs() < 1e-12);
    let constant = |_| Mat::from_fn(1, 1, |_, _| c64::from(2.0));
    let table =
        FrequencyTable::new(vec![0.0, 1.0, 3.0], (0..3).map(constant).collect(), 4.0).expect("a table");
    // the gust meets 1.5 m earlier what it is counted from later
    let value = table.at(0.8, 2.5).expect("inside")[(0, 0)];
    assert!((value - c64::new(1.2_f64.cos(), -1.2_f64.sin()) * 2.0).norm() < 1e-12);
    assert!(table.range() == (0.0, 3.0) && table.at(3.1, 0.0).is_err());
}

#[test]
fn harmonics_above_the_highest_are_left_out_and_reported() {
    let (n, dt) = (20, 0.1);
    let base = TAU / 2.0;
    let wave = |k: usize, harmonic: f64| (base * harmonic * dt * k as f64).cos();
    // mean 3, amplitudes 4 at the second harmonic and 2 at the highest of all, which alternates
    let signal: Vec<f64> = (0..n).map(|k| 3.0 + 4.0 * wave(k, 2.0) + 2.0 * wave(k, 10.0)).collect();
    let half = |omega: f64| Ok::<_, ()>(vec![c64::from(0.5), c64::new(0.0, omega)]);
    let all = periodic_response(&signal, dt, 1e9, half).expect("no error");
    assert!(all.left_out < 1e-9 && all.answers.len() == 2);
    assert!((0..n).all(|k| (all.answers[0][k] - 0.5 * signal[k]).abs() < 1e-12));
    for (highest, kept, left) in [(2.0, 2, 4.0), (1.99, 1, 20.0)] {
        let cut = periodic_response(&signal, dt, highest * base, half).expect("no error");
        assert!((cut.left_out - (left / 29.0_f64).sqrt()).abs() < 1e-9, "{highest}: {}", cut.left_out);
        for k in 0..n {
            let wanted = 3.0 + if kept == 2 { 4.0 * wave(k, 2.0) } else { 0.0 };
            assert!((cut.answers[0][k] - 0.5 * wanted).abs() < 1e-12);
        }
        let slope = |k: usize| if kept == 2 { -8.0 * base * (2.0 * base * dt * k as f64).sin() } else { 0.0 };
        assert!((0..n).all(|k| (cut.answers[1][k] - slope(k)).abs() < 1e-10));
    }
    assert_eq!(periodic_response(&[0.0; 4], dt, 1e9, half).expect("no error").left_out, 0.0);
    assert_eq!(periodic_response(&signal, dt, 1e9, |_| Err::<Vec<c64>, i32>(7)).expect_err("as it says"), 7);
}

#[test]
fn damping_is_twice_the_growth_rate_over_the_frequency() {
    let root = |re: f64, im: f64| Root { p: c64::new(re, im), beyond_table: false };
    assert!((root(-0.3, 4.0).frequency_hz() - 4.0 / TAU).abs() < 1e-12);
    assert_eq!((root(-0.3, 4.0).damping_g(), root(-0.3, 0.0).damping_g()), (Some(-0.15), None));
}

#[test]
fn the_first_divergence_is_where_the_airspeed_is_its_own_limit() {
    // the limit falls with the airspeed: V = 40 - V/2
    let falling = |v: f64| Ok::<_, ()>(Some(40.0 - 0.5 * v));
    let found = first_divergence(&[10.0, 20.0, 30.0, 40.0], falling).expect("no error").expect("divergence");
    assert!((found - 80.0 / 3.0).abs() < 1e-8, "{found}");
    assert_eq!(first_divergence(&[30.0, 40.0], falling), Ok(Some(30.0)));
    assert_eq!(first_divergence(&[10.0, 20.0], falling), Ok(None));
    assert_eq!(first_divergence(&[10.0, 20.0], |_| Ok::<_, ()>(None)), Ok(None));
    assert_eq!(first_divergence(&[5.0, 12.0], |v| if v > 10.0 { Err(v) } else { Ok(Some(99.0)) }), Err(12.0));
    assert_eq!(first_divergence(&[10.0], |v| Ok::<_, ()>(Some(v))), Ok(Some(10.0)));
}
