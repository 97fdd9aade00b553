//! Runs of the virtual wind tunnel: where they begin, what they hide, and that the shipped ones can be read.

#![expect(clippy::unwrap_used, reason = "a helper of tests may fail the test where it stands")]

use maneuver::Run;
use nastran::Table;
use std::path::{Path, PathBuf};
use tunnel::{ChannelNoise, Joiner, MotionPlan, Truth, TunnelFile, campaign};

fn data(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/tuflex").join(name)
}

/// The shipped file with hardly any noise and the runs that `keep` chooses.
fn quiet(keep: impl Fn(&MotionPlan) -> bool) -> TunnelFile {
    let mut file = TunnelFile::read(&data("tunnel.ron")).unwrap();
    file.noise.sample = ChannelNoise { fz_n: 1e-9, mx_nm: 1e-9, my_nm: 1e-9 };
    file.runs.retain(|run| keep(&run.motion));
    file
}

fn tables(file: &TunnelFile) -> Vec<Table> {
    let made = campaign(file, &Truth::build(file).unwrap(), 1).unwrap();
    let run = |name: &str| made.files.iter().find(|(file, _)| file == name).unwrap();
    file.runs.iter().map(|plan| Table::parse(&plan.file, &run(&plan.file).1).unwrap()).collect()
}

#[test]
fn a_run_begins_with_the_static_loads() {
    let file = quiet(|motion| matches!(motion, MotionPlan::OneMinusCosine { frequency_hz: 4.0, .. }));
    let truth = Truth::build(&file).unwrap();
    let expected = truth.states(30.0, &[1.3_f64.to_radians()]).unwrap()[0].loads.to_array();
    let run = &tables(&file)[0];
    for (name, expected) in ["Fz_N", "Mx_Nm", "My_Nm"].into_iter().zip(expected) {
        let first = run.number(0, name).unwrap();
        // Printed with four decimals.
        assert!((first - expected).abs() < 1e-4, "{name}: {first} {expected}");
    }
}

#[test]
fn larger_deflections_lose_more_of_their_effect() {
    let file = quiet(|motion| matches!(motion, MotionPlan::Doublet { control, .. } if control == "inner"));
    let at_30: Vec<Table> = tables(&file).into_iter().take(3).collect();
    let per_degree: Vec<f64> = at_30
        .iter()
        .map(|run| {
            let fz = run.numbers("Fz_N").unwrap();
            let delta = run.numbers("delta_inner_deg").unwrap();
            let peak = fz.iter().map(|f| f - fz[0]).fold(0.0, f64::max);
            peak / delta.iter().copied().fold(0.0, f64::max)
        })
        .collect();
    // All else is linear, so the ratios are those of 1 / (1 + (d/35)^2).
    let kept = |degrees: f64| 1.0 / (1.0 + (degrees / 35.0_f64).powi(2));
    for (found, degrees) in per_degree.iter().zip([5.0, 15.0, 25.0]) {
        let expected = kept(degrees) / kept(5.0);
        assert!((found / per_degree[0] - expected).abs() < 1e-3, "{degrees} degrees: {found} {expected}");
    }
}

#[test]
fn a_joiner_resists_pitch_acceleration() {
    let joiner = Joiner { mass_kg: 2.0, aft_m: 0.1, inertia_kg_m2: 0.05 };
    // A point mass aft of the axis accelerates down: it pulls the balance up, which is nose down.
    let loads = joiner.loads(10.0);
    assert!((loads[0] - 2.0).abs() < 1e-15 && loads[1] == 0.0 && (loads[2] + 0.5).abs() < 1e-15);
}

#[test]
fn the_shipped_runs_can_be_read_and_are_small() {
    let file = TunnelFile::read(&data("tunnel.ron")).unwrap();
    let mut bytes = 0;
    for plan in &file.runs {
        let path = data("measured").join(&plan.file);
        let run = Run::read(&path).unwrap();
        assert!((run.time_step_s - 0.005).abs() < 1e-9 && run.loads.is_some());
        assert_eq!(run.v_m_s, plan.v_m_s);
        bytes += std::fs::metadata(&path).unwrap().len();
    }
    assert!(bytes < 5_000_000, "{bytes} bytes");
}
