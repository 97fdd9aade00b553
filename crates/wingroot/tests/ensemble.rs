//! Intervals of what is computed with a calibrated wing: the shipped beam wing, calibrated and flown as a user does.

#![expect(clippy::unwrap_used, reason = "a helper of tests may fail the test where it stands")]

use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::OnceLock;

use serde_json::Value;

fn run(arguments: &[&str]) -> (Option<i32>, String) {
    let output = Command::new(env!("CARGO_BIN_EXE_wingroot"))
        .args(arguments)
        .current_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join("../.."))
        .output()
        .unwrap();
    let said = [output.stdout, output.stderr].map(|text| String::from_utf8_lossy(&text).into_owned());
    (output.status.code(), said.concat())
}

const WING: [&str; 4] = ["--wing", "data/tuflex/wing_beam.ron", "--campaign", "data/tuflex/measured"];

/// Runs a command on the shipped wing with the corrections of `folder`.
fn flown(folder: &Path, command: &[&str]) -> (Value, String) {
    let corrections = folder.join("calibrate/corrections.ron").display().to_string();
    let out = folder.join(command[0]).display().to_string();
    let arguments = [
        &command[..1],
        &WING,
        &["--corrections", &corrections, "--numbers-only", "--out", &out],
        &command[1..],
    ]
    .concat();
    let (status, said) = run(&arguments);
    assert_eq!(status, Some(0), "{said}");
    let result = std::fs::read_to_string(folder.join(command[0]).join("result.json")).unwrap();
    (serde_json::from_str(&result).unwrap(), said)
}

/// A folder with the calibration of the shipped wing in it, made once for all tests.
fn calibrated(name: &str) -> PathBuf {
    static ONCE: OnceLock<PathBuf> = OnceLock::new();
    let once = ONCE.get_or_init(|| {
        let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("ensemble");
        std::fs::remove_dir_all(&folder).ok();
        let out = folder.display().to_string();
        let (status, said) = run(&[&["calibrate", "--numbers-only"], &WING[..], &["--out", &out]].concat());
        assert_eq!(status, Some(0), "{said}");
        folder
    });
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    std::fs::remove_dir_all(&folder).ok();
    std::fs::create_dir_all(folder.join("calibrate")).unwrap();
    for name in ["corrections.ron", "ensemble.ron"] {
        std::fs::copy(once.join(name), folder.join("calibrate").join(name)).unwrap();
    }
    folder
}

#[test]
fn flights_carry_what_the_calibration_leaves_open() {
    let folder = calibrated("flights_carry");
    let runs = ["aoa_0p5hz_30_day_1.csv", "doublet_outer_15_30.csv"]
        .map(|run| format!("data/tuflex/measured/{run}"));
    let (result, said) = flown(&folder, &["simulate", "--run", &runs[0], &runs[1]]);
    assert!(said.contains("90 % intervals of the loads"), "{said}");
    let half = |run: usize| result["runs"][run]["largest_half_interval_90"]["Mx_Nm"].as_f64().unwrap();
    // root loads by the angle were measured, what an aileron does was not
    assert!(half(0) > 0.0 && half(1) > 3.0 * half(0), "{} {}", half(0), half(1));
    // shaded about the updated curve
    let curves = std::fs::read_to_string(folder.join("simulate/doublet_outer_15_30_models.csv")).unwrap();
    let head: Vec<&str> = curves.lines().next().unwrap().split(',').collect();
    let at = |name: &str| head.iter().position(|column| *column == name).unwrap();
    let [low, updated, high] = ["updated_low_Mx_Nm", "updated_Mx_Nm", "updated_high_Mx_Nm"].map(at);
    for row in curves.lines().skip(1) {
        let cells: Vec<f64> = row.split(',').map(|cell| cell.parse().unwrap()).collect();
        assert!(cells[low] <= cells[updated] && cells[updated] <= cells[high], "{row}");
    }
    let (result, _) = flown(&folder, &["simulate", "--no-intervals", "--run", &runs[0]]);
    assert!(result["intervals_from"].is_null() && result["runs"][0]["largest_half_interval_90"].is_null());
}

#[test]
fn speeds_of_flutter_and_divergence_have_intervals_where_all_wings_have_them() {
    let folder = calibrated("flutter_intervals");
    let (result, said) = flown(&folder, &["flutter", "--to", "120"]);
    assert_eq!(crate::schemas::faults_in(&folder.join("flutter"), "flutter_result"), Vec::<String>::new());
    for speed in ["flutter_speed_m_s", "divergence_speed_m_s"] {
        let Some(value) = result["updated"]["p_k"][speed].as_f64() else { continue };
        let interval = &result["intervals_90"]["of_updated"]["p_k"][speed];
        let Some(ends) = interval.as_array() else {
            assert!(said.contains("not all of them have it"), "{said}");
            continue;
        };
        let [low, high] = [0, 1].map(|end| ends[end].as_f64().unwrap());
        assert!(low < value && value < high && high - low < 0.5 * value, "{speed}: {low} {value} {high}");
    }
}

#[test]
fn an_ensemble_of_other_corrections_gives_no_intervals_and_says_so() {
    let folder = calibrated("other_corrections");
    let path = folder.join("calibrate/corrections.ron");
    let text = std::fs::read_to_string(&path).unwrap();
    let first = text.split("force: [").nth(1).unwrap().split(',').next().unwrap();
    std::fs::write(&path, text.replacen(&format!("force: [{first}"), "force: [1.25", 1)).unwrap();
    let run = "data/tuflex/measured/aoa_0p5hz_30_day_1.csv";
    let (result, said) = flown(&folder, &["simulate", "--run", run]);
    assert!(said.contains("ensemble.ron is of other corrections: no intervals"), "{said}");
    assert!(result["intervals_from"].is_null());
}
