//! Studies of decks that lack something (`--deck study.ron`), run as a user runs them: each leaves a deck with the same answers.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use serde_json::Value;

struct Folder(PathBuf);

impl Folder {
    fn new(name: &str, files: &[(&str, &str)]) -> Self {
        let folder = std::env::temp_dir().join(format!("wingroot-studies-{name}-{}", std::process::id()));
        std::fs::create_dir_all(&folder).expect("a folder of our own");
        for (file, text) in files {
            std::fs::write(folder.join(file), text).expect("a file");
        }
        Self(folder)
    }

    fn run(&self, words: &[&str]) -> Output {
        Command::new(env!("CARGO_BIN_EXE_wingroot"))
            .args(words)
            .args(["--json", "--quiet"])
            .current_dir(&self.0)
            .output()
            .expect("the command starts")
    }

    /// The result of a run that must end well.
    fn result(&self, words: &[&str]) -> Value {
        let output = self.run(words);
        assert!(output.status.success(), "{words:?}: {}", String::from_utf8_lossy(&output.stderr));
        serde_json::from_slice(&output.stdout).expect("nothing but JSON")
    }

    /// The sentence of a run that must be refused.
    fn refused(&self, words: &[&str]) -> String {
        let output = self.run(words);
        let said = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(2), "{words:?}: {said}");
        said
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.0);
    }
}

/// A wing of two motions on springs, its masses behind the axis of its springs, as structure and panels alone.
const SECTION: &str = "GRID,1,,.2,0.,0.\nGRID,2,,.3,0.,0.\nGRID,3,,.2,1.,0.\nGRID,4,,.5,1.,0.\nRBE2,13,1,123456,2,3,4\nCONM2,11,2,,4.\n\
    ,.01,,.05,,,.05\nCELAS2,14,2000.,1,3\nCELAS2,15,150.,1,5\nSPC1,1,1246,1\nCAERO1,1001,1,,4,4,,,1\n,0.,0.,0.,.5,0.,1.,0.,.5\n\
    SET1,30,1,2,3,4\nSPLINE1,20,1001,1001,1016,30\nAECOMP,ALL,CAERO,1001\nMONPNT1,ROOT    ,all of it\n,35,ALL,0,.2,0.,0.\n";

/// Gusts and flutter of it; 1/2 rho v² of the gusts is that of 20 m/s near the ground.
const STUDY: &str = "(decks: [\"section.bdf\"], spc: 1, reference: (chord: 0.5, is_half: true),
    unsteady: (modes: 2, damping: [(0.0, 0.01)], reduced_frequencies: [0.001, 0.05, 0.1, 0.2, 0.4, 0.7, 1.0, 1.5]),
    flutter: (machs: [0.0], densities: Ratios(to: 1.225, ratios: [1.0, 0.5]), airspeeds: [10.0, 20.0, 30.0, 40.0, 60.0, 80.0]),
    gusts: (mach: 0.0, v: 20.0, rho: 1.225, waves: [(name: \"5 m up\", amplitude: 2.0, gradient: 5.0),
            (name: \"5 m down\", amplitude: -2.0, gradient: 5.0)],
        frequencies: (step_hz: 0.1, lowest_hz: 0.0, highest_hz: 12.0), times: (step_s: 0.02, end_s: 4.0), grids: [1]))";

#[test]
fn flutter_and_gusts_of_a_study_are_those_of_the_deck_that_it_leaves() {
    let folder = Folder::new("section", &[("section.bdf", SECTION), ("study.ron", STUDY)]);
    for (command, answers) in [("flutter", "conditions"), ("gust", "extremes")] {
        let [first, again] = [format!("{command}_1"), format!("{command}_2")];
        let of_study = folder.result(&[command, "--deck", "study.ron", "--out", &first]);
        let deck = format!("{first}/study.bdf");
        let of_deck = folder.result(&[command, "--deck", &deck, "--out", &again]);
        let cases = of_study["subcases"].as_array().expect("a list");
        assert_eq!(cases.len(), if command == "gust" { 2 } else { 1 });
        for (at, case) in cases.iter().enumerate() {
            assert!(!case[answers].as_array().expect("a list").is_empty());
            assert_eq!(case[answers], of_deck["subcases"][at][answers], "{command}");
        }
    }
    let flutter = folder.result(&["flutter", "--deck", "study.ron", "--out", "flutter_3"]);
    let conditions = flutter["subcases"][0]["conditions"].as_array().expect("a list");
    let densities: Vec<f64> = conditions.iter().filter_map(|of| of["density"].as_f64()).collect();
    assert_eq!(densities, [1.225, 0.6125]);
    // what goes up with a gust from below goes down with one from above
    let gust = folder.result(&["gust", "--deck", "study.ron", "--out", "gust_3"]);
    let heave = |case: usize, end: &str| {
        let rows = gust["subcases"][case]["extremes"].as_array().expect("a list");
        let row =
            rows.iter().find(|row| row["of"] == "grid 1" && row["component"] == "T3").expect("it heaves");
        row[end].as_f64().expect("a number")
    };
    assert_eq!(gust["subcases"][1]["label"], "5 m down");
    assert!(heave(0, "highest") > 0.0 && (heave(0, "highest") / heave(1, "lowest") + 1.0).abs() < 1e-9);
    // steady air at the largest velocity would lift it by q S cl_alpha w/V over the spring
    let bound = 0.5 * 1.225 * 400.0 * 0.5 * std::f64::consts::TAU * 0.1 / 2000.0;
    assert!((0.1 * bound..2.5 * bound).contains(&heave(0, "highest")), "{} {bound}", heave(0, "highest"));
}

#[test]
fn what_a_study_lacks_for_a_command_is_said_in_a_sentence() {
    let folder = Folder::new("refused", &[("section.bdf", SECTION), ("study.ron", STUDY)]);
    let said = folder.refused(&["fullaircraft", "--deck", "study.ron"]);
    assert!(said.contains("the study has no section `trims`, which this command runs"), "{said}");
    assert!(said.contains("`flutter` (`flutter --deck`) and `gusts` (`gust --deck`)"), "{said}");
    let said = folder.refused(&["flutter", "--deck", "study.ron", "--subcase", "2"]);
    assert!(said.contains("subcase 2 asks for no flutter"), "{said}");
    let study = STUDY.replace("spc: 1,", "spc: 1, masses: Matrix(\"mass.op4\"),");
    std::fs::write(folder.0.join("heavy.ron"), study).expect("a file");
    std::fs::write(folder.0.join("mass.op4"), "       3       3       6       2MGG\n").expect("a file");
    let said = folder.refused(&["flutter", "--deck", "heavy.ron"]);
    assert!(said.contains("mass.op4:1:1") && said.contains("the file ends where a column"), "{said}");
    std::fs::write(folder.0.join("mass.op4"), nastran::op4_text("MGG", &vec![vec![1.0; 3]; 3]))
        .expect("a file");
    let said = folder.refused(&["gust", "--deck", "heavy.ron"]);
    assert!(said.contains("the matrix has 3 rows, but the decks' 4 grids"), "{said}");
}

fn repository(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").join(name)
}

fn read(path: &Path) -> String {
    std::fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// Level flight of HA144A at 40 psf, whose PARAM AUNITS makes accelerations multiples of gravity.
const HA144A: &str = "(decks: [\"aircraft.bdf\"], spc: 1, gravity: 1.0, support: 90,
    reference: (area: 200.0, chord: 10.0, span: 40.0, point: (15.0, 0.0, 0.0), is_half: true),
    controls: [(name: \"canard\", moves: [(\"ELEV\", 1.0)])],
    trims: [(name: \"level\", mach: 0.9, v: 1000.0, rho: 8e-5, free: [\"canard\"])])";

#[test]
fn a_plan_on_a_study_has_the_loads_of_the_plan_on_the_whole_deck() {
    let deck = read(&repository("data/published/decks/ha144a_fsw.bdf"));
    let (_, bulk) = deck.split_once("BEGIN BULK\n").expect("bulk data");
    let given = ["SUPORT,", "AEROS,", "AESTAT,", "TRIM,", "+T1,", "+T2,", "SPC1,1,1246", "ENDDATA"];
    let kept: Vec<&str> =
        bulk.lines().filter(|line| given.iter().all(|start| !line.starts_with(start))).collect();
    let plan = read(&repository("data/loads/loads_ha144a.ron"));
    let at = plan.find("        Discrete(").expect("gusts");
    let end = at + plan[at..].find("    ],").expect("an end");
    let trims = plan[..at].to_owned() + &plan[end..];
    let cards = kept.join("\n") + "\n";
    let folder = Folder::new(
        "plan",
        &[("whole.bdf", &deck), ("aircraft.bdf", &cards), ("study.ron", HA144A), ("plan.ron", &trims)],
    );
    for (deck, out) in [("whole.bdf", "whole"), ("study.ron", "study")] {
        folder.result(&["loads", "--deck", deck, "--plan", "plan.ron", "--out", out]);
    }
    let table = |out: &str| read(&folder.0.join(out).join("station_loads.csv"));
    let [whole, study] = [table("whole"), table("study")];
    assert!(whole.lines().count() > 10 && whole.lines().count() == study.lines().count());
    let numbers = |line: &str| -> Vec<f64> { line.split(',').filter_map(|cell| cell.parse().ok()).collect() };
    for (a, b) in whole.lines().zip(study.lines()).skip(1) {
        let (x, y) = (numbers(a), numbers(b));
        let size = x.iter().fold(1.0, |most: f64, value| most.max(value.abs()));
        assert!(x.len() == y.len() && x.len() > 3, "{a} {b}");
        assert!(x.iter().zip(&y).all(|(x, y)| (x - y).abs() < 1e-6 * size), "{a}\n{b}");
    }
    let left = read(&folder.0.join("study/study.bdf"));
    assert!(left.starts_with("SOL 144\nCEND\n") && left.contains("TRIM*"), "{left}");
}
