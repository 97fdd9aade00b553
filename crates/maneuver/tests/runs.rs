//! Files of runs: what is refused and where, and a simulated run as the input of another simulation.

#![allow(clippy::unwrap_used, reason = "a test whose data cannot be read must fail")]

use aero::{Corrections, Flow};
use coupling::ElasticWing;
use maneuver::motion::{Doublet, Step, ThreeTwoOneOne, sampled};
use maneuver::{Motion, Rig, RigSettings, Run, Smooth, simulate};
use std::path::{Path, PathBuf};

fn written(name: &str, text: &str) -> PathBuf {
    let folder = std::env::temp_dir().join(format!("wingroot-runs-{}-{name}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let path = folder.join("run.csv");
    std::fs::write(&path, text).unwrap();
    path
}

fn read(name: &str, text: &str) -> Result<Run, nastran::InputError> {
    let path = written(name, text);
    let run = Run::read(&path);
    std::fs::remove_dir_all(path.parent().unwrap()).unwrap();
    run
}

#[test]
fn a_cell_that_is_not_a_number_is_refused_at_its_line_and_column() {
    let message =
        read("cell", "t_s,V_m_s,alpha_deg\n0,30,1\n0.01,30,one\n0.02,30,1\n").unwrap_err().to_string();
    assert!(message.contains("run.csv:3:9"), "{message}");
}

#[test]
fn a_missing_column_is_named() {
    let message = read("column", "t_s,V_m_s\n0,30\n1,30\n2,30\n").unwrap_err().to_string();
    assert!(message.contains("run.csv") && message.contains("alpha_deg"), "{message}");
}

#[test]
fn one_load_without_the_others_is_kept_by_itself_and_none_is_an_input_to_fly() {
    let run = read("partial", "t_s,V_m_s,alpha_deg,Fz_N\n0,30,1,5\n0.01,30,1,6\n0.02,30,1,5\n").unwrap();
    assert!(run.loads.is_none(), "not all three");
    assert_eq!([0, 1, 2].map(|c| run.load(c)), [Some(&[5.0, 6.0, 5.0][..]), None, None]);
    let run = read("inputs", "t_s,V_m_s,alpha_deg\n0,30,1\n0.01,30,1\n0.02,30,1\n").unwrap();
    assert!(run.loads.is_none());
}

#[test]
fn fewer_than_three_samples_are_refused() {
    let message = read("short", "t_s,V_m_s,alpha_deg\n0,30,1\n1,30,1\n").unwrap_err().to_string();
    assert!(message.contains("three samples"), "{message}");
}

#[test]
fn a_simulated_run_flown_again_gives_its_own_loads() {
    // deflections are commands in a run's file, and a simulated one has the same columns: were they what the
    // surface did, the actuator would act twice
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/tuflex/wing_beam.ron");
    let (file, wing) = ElasticWing::read(&path).unwrap();
    let rig = Rig::new(&wing, RigSettings::new(file.damping_ratio, file.pitch_axis_x())).unwrap();
    let neutral = Corrections::neutral(wing.correctable.len());
    let model = rig.at(Flow { v_m_s: 30.0, rho_kg_m3: 1.225 }, &neutral).unwrap();
    let samples = 300;
    let doublet = sampled(&Doublet { height: 0.2, frequency_hz: 2.0, start_s: 0.1 }, 0.005, samples);
    let still = vec![0.0; samples];
    let motion = Motion {
        time_step_s: 0.005,
        alpha: Smooth { value: vec![0.02; samples], rate: still.clone(), second: still },
        controls_rad: vec![doublet],
    };
    let history = model.fly(&motion);
    let csv = written("again", &history.to_csv());
    let again = simulate(&Run::read(&csv).unwrap(), &model, &csv).unwrap();
    std::fs::remove_dir_all(csv.parent().unwrap()).unwrap();
    for (channel, rms) in again.residual_rms.unwrap().to_array().into_iter().enumerate() {
        // the file has nine digits of some 100 N
        assert!(rms < 1e-5, "channel {channel}: {rms}");
    }
}

#[test]
fn every_unit_of_a_sampled_signal_has_its_number_of_samples() {
    // edges that rounding puts just before or behind a sample, wherever the signal begins
    for start in 0..40_u32 {
        let start_s = f64::from(start) * 0.1;
        let signal = sampled(&ThreeTwoOneOne { height: 1.0, unit_s: 0.1, start_s }, 0.005, 2000);
        let count = |sign: f64| signal.iter().filter(|value| **value == sign).count();
        assert_eq!((count(1.0), count(-1.0)), (80, 60), "3-2-1-1 from {start_s} s");
        let step = sampled(&Step { height: 1.0, start_s }, 0.005, 2000);
        assert_eq!(
            step.iter().filter(|value| **value == 0.0).count(),
            20 * start as usize,
            "step at {start_s} s"
        );
    }
}

/// A run of 300 samples whose time is printed with four decimals.
fn printed(time: impl Fn(usize) -> f64) -> String {
    let rows = (0..300).map(|i| format!("{:.4},30,1\n", time(i)));
    "t_s,V_m_s,alpha_deg\n".to_owned() + &rows.collect::<String>()
}

#[test]
fn a_step_that_few_digits_blur_is_uniform_and_one_that_creeps_is_not() {
    let run = read("digits", &printed(|i| i as f64 / 300.0)).unwrap();
    assert!((run.time_step_s * 300.0 - 1.0).abs() < 1e-4);
    // 200 Hz, then 2 % slower: no single step tells, the sum does
    let creeping = |i: usize| if i < 150 { 0.005 * i as f64 } else { 0.75 + 0.0051 * (i - 150) as f64 };
    let message = read("creep", &printed(creeping)).unwrap_err().to_string();
    assert!(message.contains("the time step changes") && message.contains("run.csv:152"), "{message}");
}
