//! `gust --deck`, run as a user runs it: a mass on a spring beside closed forms, tables and figures, and refusals.

use std::f64::consts::PI;
use std::path::Path;
use std::process::{Command, Output};

use serde_json::Value;

/// A mass of 2 on a spring of 800 with a twentieth of critical damping, pushed by 4 in air so thin that it does nothing, and by a gust.
const SPRING: &str = "SOL 146\nCEND\nSPC = 1\nMETHOD = 5\nSDAMP = 6\nDISP = ALL\nFREQ = 10\nSUBCASE 1\nLABEL = a step\nDLOAD = 8\nTSTEP = 11\n\
    SUBCASE 2\nRANDOM = 12\nDLOAD = 81\nSUBCASE 3\nGUST = 7\nTSTEP = 11\nBEGIN BULK\nGRID,1,,0.,0.,0.\nGRID,2,,1.,0.,0.\nGRID,3,,0.,1.,0.\n\
    RBE2,13,1,123456,2,3\nCONM2,11,1,,2.\nCELAS2,14,800.,1,3\nSPC1,1,12456,1\nEIGRL,5,,,1\nTABDMP1,6,CRIT\n,0.,.05,99.,.05,ENDT\n\
    PAERO1,1\nCAERO1,1001,1,,1,1,,,1\n,0.,0.,0.,1.,0.,1.,0.,1.\nSET1,30,1,2,3\nSPLINE1,20,1001,1001,1001,30\nAERO,0,1.+3,1.,1.\nPARAM,Q,1.-9\n\
    MKAERO1,0.\n,.001,.05,.1,.2,.3,.4,.5\nDAREA,9,1,3,4.\nTLOAD2,8,9,,,0.,10.,0.\nRLOAD1,81,9,,,1.\nFREQ1,10,0.,.01,8000\nTSTEP,11,120,.01\n\
    RANDPS,12,2,2,2.5\nGUST,7,82,.1,0.,1.+3\nTLOAD2,82,9,,,0.,1.,1.\nAECOMP,ALL,CAERO,1001\nMONPNT1,ROOT    ,all of it\n,34,ALL,0,0.,0.,0.\nENDDATA\n";

/// Runs the command on a deck in a folder.
fn run(folder: &Path, deck: &str, more: &[&str]) -> Output {
    std::fs::write(folder.join("spring.bdf"), deck).expect("a deck");
    let mut command = Command::new(env!("CARGO_BIN_EXE_wingroot"));
    command.args(["gust", "--deck", "spring.bdf", "--out", "out", "--json", "--quiet"]).args(more);
    command.current_dir(folder).output().expect("the command starts")
}

#[test]
fn a_deck_is_answered_in_time_and_at_random_as_in_closed_form() {
    let folder = std::env::temp_dir().join(format!("wingroot-gust-{}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("a temporary folder");
    let output = run(&folder, SPRING, &[]);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let result: Value = serde_json::from_slice(&output.stdout).expect("nothing but JSON");
    let cases = result["subcases"].as_array().expect("a list");
    let kinds: Vec<(u64, bool, u64)> = cases
        .iter()
        .map(|case| (case["subcase"].as_u64(), case["in_time"].as_bool(), case["gust"].as_u64()))
        .map(|(id, time, gust)| (id.expect("a number"), time.expect("a word"), gust.expect("a number")))
        .collect();
    assert_eq!(kinds, [(1, true, 0), (2, false, 0), (3, true, 7)]);
    // the overshoot of a step: 1 + exp(-pi zeta/sqrt(1 - zeta²)) of the static deflection 4/800
    let extremes = |case: usize| cases[case]["extremes"].as_array().expect("a list");
    let of = |case: usize, name: &str, component: &str| {
        let found = extremes(case).iter().find(|row| row["of"] == name && row["component"] == component);
        found.unwrap_or_else(|| panic!("{name} {component}"))["highest"].as_f64().expect("a number")
    };
    let overshoot = 4.0 / 800.0 * (1.0 + (-PI * 0.05 / (1.0 - 0.0025_f64).sqrt()).exp());
    let highest = of(0, "grid 1", "T3");
    assert!((highest / overshoot - 1.0).abs() < 2e-3, "{highest} {overshoot}");
    // resonance: static deflection over 2 zeta sqrt(1 - zeta²); white noise: S F²/(4 k c)
    let resonance = 4.0 / 800.0 / (0.1 * (1.0 - 0.0025_f64).sqrt());
    let highest = of(1, "grid 1", "T3");
    assert!((highest / resonance - 1.0).abs() < 2e-3, "{highest} {resonance}");
    let random = result["random"].as_array().expect("a list");
    let heave =
        random.iter().find(|row| row["of"] == "grid 1" && row["component"] == "T3").expect("it moves");
    let rms = heave["rms"].as_f64().expect("a number");
    let expected = (2.5 * 16.0 / (4.0 * 800.0 * 4.0_f64)).sqrt();
    assert!((rms / expected - 1.0).abs() < 2e-3, "{rms} {expected}");
    assert!(of(2, "ROOT", "F3") > 0.0, "a gust upwards lifts");
    for name in ["grids.csv", "stations.csv", "grids_over_frequency.csv", "stations_over_frequency.csv"] {
        assert!(folder.join("out").join(name).is_file(), "{name}");
    }
    let grids = std::fs::read_to_string(folder.join("out/grids.csv")).expect("a table");
    assert_eq!(grids.lines().count(), 1 + 2 * 3 * 121, "two subcases, three grids, 121 times");
    for name in
        ["densities.csv", "densities.svg", "subcase_1_grids.svg", "subcase_3_station_root.svg", "report.html"]
    {
        assert!(folder.join("out").join(name).is_file(), "{name}");
    }
    std::fs::remove_dir_all(&folder).expect("our own folder");
}

#[test]
fn a_subcase_and_grids_are_chosen_and_what_a_deck_lacks_is_said() {
    let folder = std::env::temp_dir().join(format!("wingroot-gust-asked-{}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("a temporary folder");
    let run = |deck: &str, more: &[&str]| run(&folder, deck, more);
    let output = run(SPRING, &["--subcase", "1", "--grids", "2"]);
    let result: Value = serde_json::from_slice(&output.stdout).expect("nothing but JSON");
    let names: Vec<&Value> =
        result["subcases"][0]["extremes"].as_array().expect("a list").iter().map(|row| &row["of"]).collect();
    assert!(names.iter().all(|name| **name == "grid 2" || **name == "ROOT"), "{names:?}");
    for (deck, more, words) in [
        (SPRING.replace("GUST = 7", "GUST = 6"), &[][..], "GUST 6, which is not there"),
        (SPRING.replace("FREQ1,10", "FREQ1,13"), &[], "FREQUENCY 10, which is not there"),
        (SPRING.to_owned(), &["--subcase", "4"], "subcase 4 asks for no gust"),
        (SPRING.to_owned(), &["--grids", "9"], "no grid 9"),
        (SPRING.replace("RANDPS,12,2,2", "RANDPS,12,1,1"), &[], "given in time"),
        (SPRING.replace("AERO,0", "$"), &[], "no AERO"),
    ] {
        let output = run(&deck, more);
        let said = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(2), "{said}");
        assert!(said.contains(words), "{words}: {said}");
    }
    std::fs::remove_dir_all(&folder).expect("our own folder");
}
