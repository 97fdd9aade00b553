//! The README's first command, run as a user runs it, once for all tests: what it writes, what it puts in the place of earlier results,
//! and what its `discover` says of the shipped campaign, in which a joiner's mass and the ailerons' loss of effectiveness are
//! hidden (`data/tuflex/measured/README.md` says so; the planted numbers below are its).

#![expect(clippy::unwrap_used, reason = "a test whose results cannot be read must fail")]

use std::ffi::OsStr;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::OnceLock;

use crate::browser::{Browser, looks, use_page};
use serde_json::Value;
use wingroot::output::ResultFolder;

const STEPS: [&str; 5] = ["calibrate", "deflection", "simulate", "discover", "fullaircraft"];

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

fn wingroot(arguments: &[&OsStr]) -> std::process::Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_wingroot"));
    command.args(arguments).current_dir(root()).output().expect("the command starts")
}

fn json(path: &Path) -> Value {
    serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap()
}

/// The folder of all results: one run, over earlier ones.
pub(crate) fn out() -> &'static Path {
    static OUT: OnceLock<PathBuf> = OnceLock::new();
    OUT.get_or_init(|| {
        let out = Path::new(env!("CARGO_TARGET_TMPDIR")).join("pipeline");
        let _ = std::fs::remove_dir_all(&out);
        for step in STEPS.into_iter().chain(["pipeline"]) {
            let earlier = ResultFolder::begin(&out.join(step)).unwrap();
            earlier.write_text("earlier.txt", "of a run before").unwrap();
            earlier.commit().unwrap();
        }
        let words = ["pipeline", "--wing", "data/tuflex/wing.ron", "--json", "--out"].map(OsStr::new);
        let output = wingroot(&[&words[..], &[out.as_os_str()]].concat());
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        let printed: Value = serde_json::from_slice(&output.stdout).expect("nothing but JSON");
        assert_eq!(printed["command"], "pipeline");
        out
    })
}

/// What it says of the campaign.
fn discovered() -> &'static (PathBuf, Value) {
    static DISCOVERED: OnceLock<(PathBuf, Value)> = OnceLock::new();
    DISCOVERED.get_or_init(|| (out().join("discover"), json(&out().join("discover/result.json"))))
}

/// Every step has a page, one page links them all, and all can be used in a browser.
fn pages(out: &Path) {
    let index = std::fs::read_to_string(out.join("pipeline/report.html")).expect("the page of all");
    for step in STEPS {
        assert!(index.contains(&format!("href=\"../{step}/report.html\"")), "{step} is not linked");
        assert!(out.join(step).join("report.html").is_file(), "{step} has no page");
    }
    let Some(browser) = Browser::start() else { return };
    for step in STEPS.into_iter().chain(["pipeline"]) {
        let page = out.join(step).join("report.html");
        use_page(&browser, &page, true);
        // pages of a figure a run are too long to print in a test
        if !["simulate", "discover"].contains(&step) {
            looks::on_screens(&browser, &page, &looks::SCREENS[1..]);
            looks::prints_whole(&browser, &page);
        }
    }
}

#[test]
fn the_pipeline_writes_what_the_readme_promises_in_the_place_of_earlier_results() {
    let out = out();
    for step in STEPS.into_iter().chain(["pipeline"]) {
        assert!(!out.join(step).join("earlier.txt").exists(), "{step}: an earlier result is replaced");
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
    let result = json(&out.join("calibrate/result.json"));
    let airspeeds = result["airspeeds"].as_array().expect("a list");
    assert_eq!(airspeeds.len(), 5);
    let keys = ["V_m_s", "objective_before", "objective_after", "line_floor", "noise_floor", "iterations"];
    assert!(airspeeds.iter().all(|airspeed| keys.iter().all(|key| airspeed[key].is_number())));
    // the cards are read again by our own reader: 708 boxes, force and moment alternating
    let deck = nastran::read_deck(&out.join("calibrate/wkk_40.bdf")).expect("our own card");
    assert_eq!(deck.matrices["WKK"].rows, 1416);
    let deck = nastran::read_deck(&out.join("calibrate/fa2j_40.bdf")).expect("our own card");
    assert_eq!(deck.matrices["FA2J"].rows, 708);
    pages(out);
}

#[test]
fn the_hidden_joiner_and_saturation_are_named_and_nothing_else() {
    let (_, result) = discovered();
    let mut names: Vec<&str> =
        result["effects"].as_array().unwrap().iter().map(|e| e["name"].as_str().unwrap()).collect();
    names.sort_unstable();
    assert_eq!(names, ["ctl_saturation", "joiner_inertia"]);
    assert_eq!(result["verdict"], "effects", "{result:#}");
}

#[test]
fn the_joiner_s_inertia_and_first_moment_are_the_planted_ones() {
    let (_, result) = discovered();
    let joiner =
        result["effects"].as_array().unwrap().iter().find(|e| e["name"] == "joiner_inertia").unwrap();
    let value = |name: &str| joiner["parameters"][name]["value"].as_f64().unwrap();
    // planted: 5 kg, .02 m forward, .15 kg m2 about the pitch axis
    let (inertia, moment) = (value("Iyy_kg_m2"), value("mx_kg_m"));
    assert!((inertia / 0.15 - 1.0).abs() < 0.03, "{inertia}");
    // to half of the standard deviation that is stated, a tenth of it. It was 3 %: the value is .1031 where the wing's file leaves nothing of
    // the wake open, .1044 as it stands, and was .1027 while that nuisance had the wrong shape
    let sigma = joiner["parameters"]["mx_kg_m"]["sigma"].as_f64().unwrap();
    assert!(sigma < 0.011 && (moment + 0.1).abs() < 0.5 * sigma, "{moment} +- {sigma}");
}

#[test]
fn the_held_out_gap_closes_to_at_most_twice_its_floor() {
    let (_, result) = discovered();
    let gap = |name: &str| result["gap"]["holdout"][name].as_f64().unwrap();
    // with sizes of the search alone it was .52 of the gap before (our own earlier result)
    assert!(gap("after") < 0.5 * gap("before") && gap("after") <= 2.0 * gap("floor"), "{}", result["gap"]);
    assert_eq!(result["success"], true);
}

#[test]
fn the_residual_is_located_in_large_deflections_and_fast_pitch() {
    let (_, result) = discovered();
    let located = result["located"].as_array().unwrap();
    let has = |channel: &str, regressor: &str| {
        located
            .iter()
            .any(|l| l["channel"] == channel && l["regressor"].as_str().unwrap().contains(regressor))
    };
    assert!(has("Fz_N", "delta|delta|") && has("My_Nm", "alpha_ddot"), "{located:#?}");
}

#[test]
fn the_updated_wing_reads_back_with_its_effects_and_new_corrections() {
    let (out, _) = discovered();
    let wing = coupling::WingFile::read(&out.join("wing.ron")).unwrap();
    let names: Vec<&str> = wing.effects.iter().map(|effect| effect.name.as_str()).collect();
    assert_eq!(names.len(), 2, "{names:?}");
    let corrections = calibrate::Schedule::read(&out.join("corrections.ron")).unwrap();
    assert_eq!(corrections.wing_hash, wing.hash);
    assert_eq!(corrections.sets.len(), 5);
    assert!(out.join("runs/aoa_4hz_30.svg").is_file() && out.join("map.csv").is_file());
}

#[test]
fn the_shipped_null_distribution_belongs_to_the_shipped_wing_and_campaign_and_has_every_effect() {
    let path = root().join("data/tuflex/null_distribution.ron");
    let nulls: discover::null_distribution::NullDistribution = nastran::ron_file::read(&path).unwrap();
    // what the command was run with, and writes again
    let (out, _) = discovered();
    let used = nastran::ron_file::read(&out.join("null_distribution.ron")).unwrap();
    assert_eq!(nulls, used, "made for {:?}", nulls.key.differs_in(&used.key));
    let result = std::fs::read_to_string(out.join("result.json")).unwrap();
    assert!(result.contains("data/tuflex/null_distribution.ron"), "made anew");
    assert!(nulls.serves(&nulls.key, &maneuver::effects::library(&["any".to_owned()])));
    assert!(nulls.floor.iter().all(|floor| *floor > 1.0), "{nulls:?}");
}

#[test]
fn a_wing_that_has_effects_already_is_refused() {
    let (out, _) = discovered();
    let wing = out.join("wing.ron");
    let twice = out.join("../twice");
    let words = ["discover", "--campaign", "data/tuflex/measured", "--wing"].map(OsStr::new);
    let output =
        wingroot(&[&words[..], &[wing.as_os_str(), OsStr::new("--out"), twice.as_os_str()]].concat());
    let (status, said) = (output.status.code(), String::from_utf8_lossy(&output.stderr));
    assert_eq!(status, Some(2), "{said}");
    assert!(said.contains("the wing has effects already") && said.contains("hint: "), "{said}");
}
