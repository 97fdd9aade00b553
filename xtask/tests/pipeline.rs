//! The README's first command, run as a user runs it: what it writes, and that it can be run again.

use std::path::Path;
use std::process::Command;

fn xtask(arguments: &[&str]) -> std::process::Output {
    Command::new(env!("CARGO_BIN_EXE_xtask"))
        .args(arguments)
        .current_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join(".."))
        .output()
        .expect("the command starts")
}

#[test]
fn the_pipeline_writes_what_the_readme_promises() {
    let out = std::env::temp_dir().join(format!("wingroot-pipeline-{}", std::process::id()));
    let folder = out.to_string_lossy().into_owned();
    // twice: an earlier result is replaced
    for _ in 0..2 {
        let output = xtask(&["pipeline", "--out", &folder, "--json"]);
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        let printed: serde_json::Value = serde_json::from_slice(&output.stdout).expect("nothing but JSON");
        assert_eq!(printed["command"], "pipeline");
    }
    let mut expected = vec![
        "calibrate/corrections.ron".to_owned(),
        "calibrate/static_loads.svg".into(),
        "simulate/aoa_2hz_30.csv".into(),
        "fullaircraft/doublet_initial.csv".into(),
        "fullaircraft/doublet_updated.csv".into(),
        "fullaircraft/pull_up.svg".into(),
    ];
    for v in [18, 22, 30, 34, 40] {
        expected.push(format!("calibrate/wkk_{v}.bdf"));
        expected.push(format!("calibrate/fa2j_{v}.bdf"));
    }
    for command in ["calibrate", "simulate", "fullaircraft"] {
        expected.push(format!("{command}/result.json"));
    }
    for name in &expected {
        assert!(out.join(name).is_file(), "{name} is missing");
    }
    let text = std::fs::read_to_string(out.join("calibrate/result.json")).expect("just seen");
    let result: serde_json::Value = serde_json::from_str(&text).expect("JSON");
    let airspeeds = result["airspeeds"].as_array().expect("a list");
    assert_eq!(airspeeds.len(), 5);
    let keys = ["V_m_s", "objective_before", "objective_after", "line_floor", "noise_floor", "iterations"];
    assert!(airspeeds.iter().all(|airspeed| keys.iter().all(|key| airspeed[key].is_number())));
    // the cards are read again by our own reader: 708 boxes, force and moment alternating
    let deck = nastran::read_deck(&out.join("calibrate/wkk_40.bdf")).expect("our own card");
    assert_eq!(deck.matrices["WKK"].rows, 1416);
    let deck = nastran::read_deck(&out.join("calibrate/fa2j_40.bdf")).expect("our own card");
    assert_eq!(deck.matrices["FA2J"].rows, 708);
    std::fs::remove_dir_all(&out).expect("our own folder");
}
