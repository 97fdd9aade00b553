//! Bounds and constraints of effects, and the order in which they act.

#![allow(clippy::unwrap_used, reason = "a test whose data cannot be read must fail")]

use crate::common::flown::{effect, points, rom, run, with};
use crate::common::wing_with;
use coupling::Mount;
use maneuver::effects::{Active, library};
use maneuver::rom::StiffnessParts;
use maneuver::{Rig, RigSettings};

#[test]
fn a_delay_delays_what_a_joiner_adds_in_whatever_order_they_are_named() {
    let rom = rom(30.0);
    let stimulus = run(rom.controls.len());
    let of = |name: &str, values: &[f64]| {
        Active::new(library(&rom.controls).into_iter().find(|e| e.spec().name == name).unwrap(), values)
    };
    // a whole number of samples: later by nothing but places in the list
    let delay = of("delay", &[3.0 * stimulus.time_step_s]);
    let joiner = of("joiner_inertia", &[0.05, 0.1, 0.05, 0.0]);
    let alone = with(&rom, std::slice::from_ref(&joiner), &stimulus);
    for both in [[delay.clone(), joiner.clone()], [joiner, delay]] {
        let late = with(&rom, &both, &stimulus);
        for (late, alone) in late.loads.iter().zip(&alone.loads) {
            let apart = late[3..].iter().zip(alone).map(|(late, early)| (late - early).abs());
            assert!(apart.fold(0.0, f64::max) < 1e-9);
        }
    }
}

#[test]
fn bounds_hold_zero_is_allowed_and_constraints_move_nothing_twice() {
    let controls = ["inner".to_owned(), "outer".to_owned()];
    let all = library(&controls);
    for effect in &all {
        let parameters = effect.parameters();
        for p in &parameters {
            assert!(p.lower <= 0.0 && p.upper >= 0.0 && p.lower < p.upper && p.plausible > 0.0, "{p:?}");
        }
        for share in [-2.0, -0.5, 0.0, 0.5, 2.0] {
            let values: Vec<f64> = parameters.iter().map(|p| share * p.upper.max(-p.lower)).collect();
            let once = Active::new(effect.clone(), &values);
            let twice = Active::new(effect.clone(), &once.values);
            for (a, b) in once.values.iter().zip(&twice.values) {
                assert!((a - b).abs() <= 1e-12 * a.abs(), "{}: {a} {b}", effect.spec().name);
            }
            for (value, p) in once.values.iter().zip(&parameters) {
                assert!(*value >= p.lower && *value <= p.upper);
            }
        }
    }
    let known = |name: &str| all.iter().any(|e| e.spec().name == name);
    let rivals: Vec<&str> = all.iter().flat_map(|e| e.spec().rivals).copied().collect();
    for rival in rivals {
        assert!(known(rival), "{rival} is nobody's name");
    }
}

#[test]
fn a_body_on_the_balance_is_heavy_enough_for_its_moments() {
    let joiner = library(&[]).into_iter().find(|e| e.spec().name == "joiner_inertia").unwrap();
    let impossible = Active::new(joiner, &[0.3, 0.001, 0.4, 0.0]);
    let [mx, iyy, mz, _] = impossible.values[..] else { panic!("four parameters") };
    assert!(mx * mx + mz * mz <= 10.0 * iyy * (1.0 + 1e-12), "{mx} {iyy} {mz}");
}

#[test]
fn stiffness_splits_into_bending_and_torsion_and_a_stiffer_wing_is_one_with_stiffer_modes() {
    let (file, wing) = wing_with(|_| ());
    let rig = Rig::new(&wing, RigSettings::new(file.damping_ratio, file.pitch_axis_x())).unwrap();
    let parts = StiffnessParts::new(&rig, &file.bulk(Mount::Tunnel).unwrap()).unwrap().unwrap();
    // the first mode bends, and some mode twists: its energy lies in the torsion constant
    let share = |i: usize| parts.torsion[(i, i)] / (parts.torsion[(i, i)] + parts.bending[(i, i)]);
    let shares: Vec<f64> = (0..parts.torsion.nrows()).map(share).collect();
    assert!(shares.iter().all(|s| (-1e-9..=1.0 + 1e-9).contains(s)), "{shares:?}");
    assert!(shares[0] < 0.1 && shares.iter().any(|s| *s > 0.6), "{shares:?}");
}

#[test]
fn an_error_of_dynamic_pressure_scales_what_the_air_does_and_nothing_else() {
    let rom = rom(30.0);
    let stimulus = points(rom.controls.len());
    let q = with(&rom, &[Active::new(effect(&rom, "q_error"), &[0.05])], &stimulus);
    let clean = with(&rom, &[], &stimulus);
    // an elastic wing washes out: less than in proportion
    let ratio = q.loads[0][4] / clean.loads[0][4];
    assert!(ratio > 1.0 && ratio < 1.06, "{ratio}");
}
