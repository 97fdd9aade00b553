//! Residuals by hand; what a run moves.

use super::*;
use crate::rig_model::Inputs;
use aero::Flow;
use faer::Mat;
use std::f64::consts::TAU;

/// A state that nothing moves; Fz is the second control, Mx alpha, My nothing.
fn model(cutoff_hz: f64) -> RigModel {
    let mut d = Mat::zeros(4, 8);
    d[(0, Inputs::CONTROLS + 1)] = 2.0;
    d[(1, Inputs::ALPHA)] = 3.0;
    RigModel {
        a: Mat::from_fn(1, 1, |_, _| -1.0),
        b: Mat::zeros(1, 8),
        c: Mat::zeros(4, 1),
        d,
        inputs: Inputs::new(2),
        controls: ["inner", "outer"].map(str::to_owned).to_vec(),
        sensors: Vec::new(),
        loads: ["Fz_N", "Mx_Nm", "My_Nm"].map(str::to_owned).to_vec(),
        flow: Flow { v_m_s: 20.0, rho_kg_m3: 1.2 },
        gravity_m_s2: 9.81,
        cutoff_hz,
    }
}

fn run(loads: Option<[Vec<f64>; 3]>, controls_rad: Vec<(String, Vec<f64>)>) -> Run {
    let samples = 40;
    Run {
        name: "run".into(),
        t_s: (0..samples).map(|i| 7.0 + 0.01 * f64::from(i)).collect(),
        time_step_s: 0.01,
        v_m_s: 20.0,
        alpha_rad: vec![0.1; 40],
        loads,
        some_loads: [None, None, None],
        controls_rad,
        tip_z_m: None,
        accelerations: Vec::new(),
    }
}

/// Above half the sampling rate nothing is filtered.
#[test]
fn residuals_are_root_mean_squares_and_shares_of_the_variation_about_the_mean() {
    let wave = |height: f64| (0..40).map(move |i| height * (TAU * f64::from(i) / 20.0).sin());
    let measured = [
        wave(3.0).map(|x| 5.0 + x).collect(),
        wave(4.0).map(|x| x - 2.0).collect(),
        (0..40).map(|i| if i % 2 == 0 { 0.5 } else { -0.5 }).collect(),
    ];
    let mut history = TimeHistory::default();
    // Fz is short by .6, Mx has half of the swing; My is not there
    history.push("Fz_N", wave(3.0).map(|x| 4.4 + x).collect());
    history.push("Mx_Nm", wave(2.0).map(|x| x - 2.0).collect());
    let run = run(Some(measured), Vec::new());
    let found = Simulated::of(&run, history.clone(), &model(1e3));
    let (rms, percent) = (found.residual_rms.expect("loads"), found.residual_percent.expect("loads"));
    let half = 2.0_f64.sqrt();
    assert!((rms[Load::Fz] - 0.6).abs() < 1e-12 && (rms[Load::Mx] - 2.0 / half).abs() < 1e-12, "{rms:?}");
    assert!((percent[Load::Fz] - 100.0 * 0.6 * half / 3.0).abs() < 1e-9, "{percent:?}");
    assert!((percent[Load::Mx] - 50.0).abs() < 1e-9, "{percent:?}");
    assert_eq!(found.history, history);
    // behind a filter what alternates is gone from what is measured
    history.push("My_Nm", vec![0.0; 40]);
    let filtered = Simulated::of(&run, history, &model(2.0)).residual_rms.expect("loads");
    assert!(filtered[Load::My] < 0.05 && (filtered[Load::Fz] - 0.6).abs() < 1e-6, "{filtered:?}");
}

#[test]
fn a_run_flies_its_angle_and_its_commands_at_its_own_times() {
    let outer: Vec<f64> = (0..40).map(|i| 0.01 * f64::from(i)).collect();
    let moved = run(None, vec![("outer".into(), outer.clone())]);
    let motion = motion_of(&moved, &model(25.0), Path::new("nowhere.csv")).expect("known");
    assert_eq!(motion.controls_rad, [vec![0.0; 40], outer.clone()]);
    assert_eq!((motion.time_step_s, motion.alpha.value.len()), (0.01, 40));
    let flown = simulate(&moved, &model(25.0), Path::new("nowhere.csv")).expect("known");
    assert_eq!(flown.history.t_s, moved.t_s);
    let fz = flown.history.get("Fz_N").expect("a channel");
    assert!(fz.iter().zip(&outer).all(|(fz, delta)| (fz - 2.0 * delta).abs() < 1e-12), "{fz:?}");
    let mx = flown.history.get("Mx_Nm").expect("a channel");
    assert!(mx.iter().all(|mx| (mx - 0.3).abs() < 1e-9), "{mx:?}");
    assert!(flown.residual_rms.is_none() && flown.residual_percent.is_none());
    let unknown = run(None, vec![("outr".into(), outer)]);
    let error = simulate(&unknown, &model(25.0), Path::new("nowhere.csv")).expect_err("no such control");
    assert!(error.message.contains("outr") && error.help.expect("a hint").contains("delta_outer_deg"));
}
