//! The README's first command, run as a user runs it: what it writes, and that it can be run again.

mod browser;

use std::path::Path;
use std::process::Command;

use browser::{Browser, looks, use_page};

fn wingroot(arguments: &[&str]) -> std::process::Output {
    Command::new(env!("CARGO_BIN_EXE_wingroot"))
        .args(arguments)
        .current_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join("../.."))
        .output()
        .expect("the command starts")
}

/// Every step has a page, one page links them all, and all can be used in a browser.
fn pages(out: &Path) {
    let steps = ["calibrate", "deflection", "simulate", "discover", "fullaircraft"];
    let index = std::fs::read_to_string(out.join("pipeline/report.html")).expect("the page of all");
    for step in steps {
        assert!(index.contains(&format!("href=\"../{step}/report.html\"")), "{step} is not linked");
        assert!(out.join(step).join("report.html").is_file(), "{step} has no page");
    }
    let Some(browser) = Browser::start() else { return };
    for step in steps.into_iter().chain(["pipeline"]) {
        let page = out.join(step).join("report.html");
        use_page(&browser, &page, true);
        // pages of a figure a run are too long to print in a test
        if !["simulate", "discover"].contains(&step) {
            looks::fits_every_width(&browser, &page);
            looks::is_readable_in_the_dark(&browser, &page);
            looks::prints_whole(&browser, &page);
        }
    }
}

#[test]
fn the_pipeline_writes_what_the_readme_promises() {
    let out = std::env::temp_dir().join(format!("wingroot-pipeline-{}", std::process::id()));
    let folder = out.to_string_lossy().into_owned();
    // twice: an earlier result is replaced
    for _ in 0..2 {
        let output = wingroot(&["pipeline", "--wing", "data/tuflex/wing.ron", "--out", &folder, "--json"]);
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
    pages(&out);
    std::fs::remove_dir_all(&out).expect("our own folder");
}
