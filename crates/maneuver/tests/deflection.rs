//! The deflection correction: how it interpolates, where it refuses, and that it stands before the actuator.

#![expect(clippy::unwrap_used, reason = "a helper of tests may fail the test where it stands")]

use aero::{Corrections, Flow};
use coupling::wing_file::{DeflectionRow, DeflectionTable, OutsideAirspeeds};
use maneuver::motion::{Doublet, sampled};
use maneuver::{
    DeflectionCorrection, Motion, Rig, RigSettings, Run, Smooth, fly_commanded, simulate_commanded,
};
use std::path::Path;

fn row(v_m_s: f64, commanded_deg: &[f64], factor: &[f64]) -> DeflectionRow {
    DeflectionRow {
        v_m_s,
        commanded_deg: commanded_deg.to_vec(),
        equivalent_deg: None,
        factor: Some(factor.to_vec()),
    }
}

fn table() -> DeflectionTable {
    DeflectionTable {
        control: "inner".to_owned(),
        odd: true,
        outside: OutsideAirspeeds::Refuse,
        // the second airspeed lists other deflections
        rows: vec![row(20.0, &[5.0, 15.0, 25.0], &[1.0, 0.9, 0.7]), row(30.0, &[10.0, 30.0], &[0.8, 0.4])],
    }
}

/// K at an airspeed and a deflection in degrees.
fn factor(table: DeflectionTable, v_m_s: f64, degrees: f64) -> f64 {
    DeflectionCorrection::new(vec![table]).at(v_m_s).unwrap().factor("inner", degrees.to_radians())
}

#[test]
fn factors_are_linear_between_deflections_and_between_airspeeds_and_kept_at_the_ends() {
    for (v_m_s, degrees, expected) in [
        (20.0, 15.0, 0.9),
        (20.0, 10.0, 0.95),
        (20.0, 22.5, 0.75),
        (20.0, 1.0, 1.0),
        (20.0, 40.0, 0.7),
        (30.0, 20.0, 0.6),
        // halfway between the airspeeds: (0.9 + 0.7)/2
        (25.0, 15.0, 0.8),
        // a tunnel strays by 2 %
        (30.5, 20.0, 0.6),
        (19.7, 15.0, 0.9),
    ] {
        let found = factor(table(), v_m_s, degrees);
        assert!((found - expected).abs() < 1e-12, "{v_m_s} m/s, {degrees} degrees: {found}, {expected}");
        assert_eq!(found, factor(table(), v_m_s, -degrees), "odd by default");
    }
}

#[test]
fn a_table_with_both_signs_is_followed_on_each_side() {
    let two_sided = DeflectionTable {
        odd: false,
        rows: vec![row(30.0, &[-20.0, -10.0, 10.0], &[0.5, 0.7, 0.9])],
        ..table()
    };
    for (degrees, expected) in [(-30.0, 0.5), (-15.0, 0.6), (0.0, 0.8), (5.0, 0.85), (30.0, 0.9)] {
        let found = factor(two_sided.clone(), 30.0, degrees);
        assert!((found - expected).abs() < 1e-12, "{degrees} degrees: {found}, {expected}");
    }
}

#[test]
fn an_airspeed_outside_is_refused_unless_the_nearest_is_asked_for() {
    let refused = DeflectionCorrection::new(vec![table()]).at(35.0).unwrap_err();
    assert!(
        refused.message.contains("from 20 to 30 m/s") && refused.help.unwrap().contains("outside: Nearest")
    );
    let nearest = DeflectionTable { outside: OutsideAirspeeds::Nearest, ..table() };
    assert!((factor(nearest.clone(), 60.0, 20.0) - 0.6).abs() < 1e-12);
    assert!((factor(nearest, 5.0, 15.0) - 0.9).abs() < 1e-12);
    // without wind there is nothing to correct, and no airspeed to refuse
    assert_eq!(factor(table(), 0.0, 15.0), 1.0);
}

#[test]
fn a_command_beyond_the_largest_measured_deflection_is_reported() {
    let at = DeflectionCorrection::new(vec![table()]).at(20.0).unwrap();
    let commands = |degrees: f64| vec![0.0, degrees.to_radians(), -degrees.to_radians()];
    assert_eq!(at.beyond("inner", &commands(25.0)), None);
    assert_eq!(at.beyond("outer", &commands(80.0)), None);
    let beyond = at.beyond("inner", &commands(28.0)).unwrap().to_string();
    assert!(beyond.contains("inner") && beyond.contains("25.0") && beyond.contains("28.0"), "{beyond}");
}

#[test]
fn commanded_deflections_are_corrected_before_the_actuator_and_written_as_commanded() {
    let (file, wing) = crate::common::wing_with(|_| ());
    let rig = Rig::new(&wing, RigSettings::new(file.damping_ratio, file.pitch_axis_x())).unwrap();
    let neutral = Corrections::neutral(wing.correctable.len());
    let model = rig.at(Flow { v_m_s: 20.0, rho_kg_m3: 1.225 }, &neutral).unwrap();
    let samples = 200;
    let height = 25.0_f64.to_radians();
    let commanded = sampled(&Doublet { height, frequency_hz: 2.0, start_s: 0.1 }, 0.005, samples);
    let still = vec![0.0; samples];
    let motion = Motion {
        time_step_s: 0.005,
        alpha: Smooth { value: vec![0.02; samples], rate: still.clone(), second: still },
        controls_rad: vec![commanded.clone()],
    };
    let correction = DeflectionCorrection::new(vec![table()]).at(20.0).unwrap();
    let corrected = fly_commanded(&model, &motion, &correction);
    // what acts is a doublet of 0.7 times 25 degrees, through the same actuator
    let acting = commanded.iter().map(|delta| 0.7 * delta).collect();
    let expected = model.fly(&Motion { controls_rad: vec![acting], ..motion });
    for channel in ["Fz_N", "Mx_Nm", "My_Nm", "tip_z_m"] {
        for (a, b) in corrected.get(channel).unwrap().iter().zip(expected.get(channel).unwrap()) {
            assert!((a - b).abs() <= 1e-9 * b.abs().max(1.0), "{channel}: {a} {b}");
        }
    }
    let written = corrected.get("delta_inner_deg").unwrap();
    assert!(written.iter().zip(&commanded).all(|(w, c)| (w - c.to_degrees()).abs() < 1e-12));
    // the history as a measured run flown again, with the same correction: no residual
    let run = Run {
        name: "again".to_owned(),
        t_s: corrected.t_s.clone(),
        time_step_s: 0.005,
        v_m_s: 20.0,
        alpha_rad: vec![0.02; samples],
        loads: Some(["Fz_N", "Mx_Nm", "My_Nm"].map(|name| corrected.get(name).unwrap().to_vec())),
        some_loads: [None, None, None],
        controls_rad: vec![("inner".to_owned(), commanded)],
        tip_z_m: None,
        accelerations: Vec::new(),
    };
    let again = simulate_commanded(&run, &model, &correction, Path::new("again.csv")).unwrap();
    assert!(again.residual_rms.unwrap().iter().all(|rms| *rms < 1e-8), "{:?}", again.residual_rms);
    assert_eq!(again.history.get("delta_inner_deg").unwrap(), written);
}
