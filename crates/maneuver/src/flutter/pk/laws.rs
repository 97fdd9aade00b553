//! One coordinate: its root is that of a parabola.

use super::super::FormulaForces;
use super::super::complete::Branch;
use super::*;
use faer::Mat;

/// Q = 1 + i kappa d.
fn forces(d: f64) -> FormulaForces<impl Fn(f64) -> Mat<c64>> {
    FormulaForces {
        size: 1,
        range: (0.0, 1e4),
        formula: move |k| Mat::from_fn(1, 1, |_, _| c64::new(1.0, k * d)),
    }
}

/// p² + (2 zeta 10 - q d/V) p + 100 - q: the root that is followed.
fn root(flow: Flow, zeta: f64, d: f64) -> c64 {
    let (q, v) = (flow.dynamic_pressure_pa(), flow.v_m_s);
    let (half, rest) = (0.5 * (20.0 * zeta - q * d / v), 100.0 - q);
    let square = half * half - rest;
    if square > 0.0 { c64::from(-half + square.sqrt()) } else { c64::new(-half, (-square).sqrt()) }
}

fn flows(speeds: &[f64]) -> Vec<Flow> {
    speeds.iter().map(|v| Flow { v_m_s: *v, rho_kg_m3: 2.0 }).collect()
}

#[test]
fn a_leg_is_mixed_in_proportion_and_ends_exactly() {
    let place = |v_m_s: f64, rho_kg_m3: f64, share: f64| Place { flow: Flow { v_m_s, rho_kg_m3 }, share };
    let leg = Leg { from: place(10.0, 1.0, 0.2), to: place(18.0, 0.6, 1.0) };
    let middle = leg.at(0.25);
    assert!((middle.flow.v_m_s - 12.0).abs() < 1e-12 && (middle.flow.rho_kg_m3 - 0.9).abs() < 1e-12);
    assert!((middle.share - 0.4).abs() < 1e-12);
    assert_eq!((leg.at(0.0), leg.at(1.0)), (leg.from, leg.to));
}

#[test]
fn an_oscillation_that_stops_becomes_the_less_stable_real_root() {
    let air = forces(-1.5);
    let system = Aeroelastic::of_modes(&[10.0], 0.02, &air).expect("one mode");
    let flows = flows(&[2.0, 5.0, 8.0, 9.5]);
    let curves = system.pk(&flows).expect("flows");
    assert!(curves.lost.is_empty() && curves.branches.len() == 1, "{:?} {:?}", curves.lost, curves.branches);
    for (found, flow) in curves.branches[0].iter().zip(&flows) {
        let wanted = root(*flow, 0.02, -1.5);
        assert!((found.p - wanted).norm() < 1e-8 * wanted.norm(), "{} m/s: {} {wanted}", flow.v_m_s, found.p);
    }
    assert!(curves.crossings.is_empty() && curves.branches[0].len() == 4);
    assert!(curves.flutter().is_none());
}

/// omega = 10, zeta = .02 and Q = 1 - 1.5 i kappa: the real root is zero where q = 100, which is 10 m/s.
fn assert_divergence(speeds: &[f64]) {
    let air = forces(-1.5);
    let system = Aeroelastic::of_modes(&[10.0], 0.02, &air).expect("one mode");
    let flows = flows(speeds);
    let curves = system.pk(&flows).expect("flows");
    assert!(curves.lost.is_empty(), "{speeds:?}: {:?}", curves.lost);
    let complete = system.pk_complete(&flows).expect("flows");
    for (found, flow) in curves.branches[0].iter().zip(&flows) {
        let wanted = root(*flow, 0.02, -1.5);
        assert!((found.p - wanted).norm() < 1e-8, "{} m/s: {} {wanted}", flow.v_m_s, found.p);
    }
    let there = curves.branches[0][flows.len() - 1].p;
    let is_there =
        |branch: &Branch| branch.at(flows.len() - 1).is_some_and(|root| (root.p - there).norm() < 1e-8);
    assert!(complete.branches.iter().any(is_there), "{there} {:?}", complete.branches);
    for crossings in [&curves.crossings, &complete.crossings] {
        let [found] = crossings[..] else { panic!("{speeds:?}: {crossings:?}") };
        assert!((found.flow.v_m_s - 10.0).abs() < 1e-9 && found.omega_rad_s == 0.0, "{found:?}");
        assert_eq!(found.unstable, speeds[0] < 10.0);
    }
    assert_eq!(complete.divergence().is_some(), speeds[0] < 10.0);
    assert!(curves.flutter().is_none() && complete.flutter().is_none());
}

#[test]
fn a_real_root_is_followed_through_zero_and_divergence_is_where_it_is() {
    assert_divergence(&[2.0, 5.0, 8.0, 9.5, 11.0, 13.0]);
    assert_divergence(&[9.0, 10.5]);
    // on the way back, and with a flow on either side of it that is as near as numbers are
    assert_divergence(&[12.0, 9.7]);
    assert_divergence(&[9.0, 10.0 - 1e-12, 10.0 + 1e-12, 10.5]);
}

#[test]
fn growth_begins_where_the_air_gives_what_the_structure_takes_and_ends_on_the_way_back() {
    // 20 zeta = V d at rho 2 kg/m³: 4 m/s, where omega² = 84
    let air = forces(0.2);
    let system = Aeroelastic::of_modes(&[10.0], 0.04, &air).expect("one mode");
    let curves = system.pk(&flows(&[1.0, 3.0, 7.0, 2.0])).expect("flows");
    let said: Vec<(f64, f64, bool)> =
        curves.crossings.iter().map(|c| (c.flow.v_m_s, c.omega_rad_s, c.unstable)).collect();
    assert_eq!(said.len(), 2, "{said:?}");
    for ((v, omega, unstable), wanted) in said.into_iter().zip([true, false]) {
        assert!(
            (v - 4.0).abs() < 1e-9 && (omega - 84.0_f64.sqrt()).abs() < 1e-8 && unstable == wanted,
            "{v} {omega}"
        );
    }
    assert!((curves.flutter().expect("growth").flow.v_m_s - 4.0).abs() < 1e-9);
}

/// Damping 2 zeta omega - V d at rho 2 kg/m³: with zeta .04 and d .2, 10 and 15 rad/s grow from 4 and 6 m/s on.
#[test]
fn changes_of_several_modes_stand_in_the_order_of_the_way_whichever_way_it_goes() {
    let formula =
        |k: f64| Mat::from_fn(2, 2, |i, j| if i == j { c64::new(1.0, 0.2 * k) } else { c64::default() });
    let air = FormulaForces { size: 2, range: (0.0, 1e4), formula };
    let system = Aeroelastic::of_modes(&[10.0, 15.0], 0.04, &air).expect("two modes");
    let (begin, end) = ([(4.0, true), (6.0, true)], [(6.0, false), (4.0, false)]);
    for (speeds, wanted) in [
        (vec![1.0, 8.0], begin.to_vec()),
        (vec![8.0, 1.0], end.to_vec()),
        (vec![1.0, 8.0, 2.0], [begin, end].concat()),
    ] {
        let flows = flows(&speeds);
        let (pk, complete) = (system.pk(&flows).expect("flows"), system.pk_complete(&flows).expect("flows"));
        for crossings in [&pk.crossings, &complete.crossings] {
            let said: Vec<(f64, bool)> =
                crossings.iter().map(|c| ((1e6 * c.flow.v_m_s).round() / 1e6, c.unstable)).collect();
            assert_eq!(said, wanted, "{speeds:?}");
        }
    }
}

#[test]
fn modes_ascend_and_a_coordinate_without_stiffness_has_none() {
    let formula = |_: f64| Mat::from_fn(2, 2, |_, _| c64::default());
    let air = FormulaForces { size: 2, range: (0.0, 1.0), formula };
    let modes = Aeroelastic::of_modes(&[30.0, 10.0], 0.0, &air).expect("two").modes().expect("two modes");
    assert!(
        (modes[0].p - c64::new(0.0, 10.0)).norm() < 1e-9 && (modes[1].p - c64::new(0.0, 30.0)).norm() < 1e-9
    );
    assert!(modes[0].u[1].norm() > 0.9 && modes[0].u[0].norm() < 1e-9 && !modes[0].real && !modes[0].beyond);
    let error = Aeroelastic::of_modes(&[30.0, 0.0], 0.0, &air).expect("two").modes();
    assert!(matches!(error, Err(FlutterError::Number { .. })));
}
