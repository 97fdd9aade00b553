//! The flutter command, run as a user runs it, on the measured Pazy wing.

use std::path::Path;
use std::process::Command;

use serde_json::Value;

#[test]
fn both_methods_and_models_are_in_the_result_and_agree_on_divergence() {
    let out = std::env::temp_dir().join(format!("wingroot-flutter-{}", std::process::id()));
    let folder = out.to_string_lossy().into_owned();
    let arguments =
        ["flutter", "--wing", "data/pazy/wing.ron", "--campaign", "data/pazy/tip_5deg", "--to", "120"];
    let output = Command::new(env!("CARGO_BIN_EXE_wingroot"))
        .args(arguments)
        .args(["--out", &folder, "--json"])
        .current_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join("../.."))
        .output()
        .expect("the command starts");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let result: Value = serde_json::from_slice(&output.stdout).expect("nothing but JSON");
    for model in ["initial", "updated"] {
        for method in ["state_matrix", "p_k"] {
            let numbers = &result[model][method];
            let flutter = numbers["flutter_speed_m_s"].as_f64();
            let said = numbers["remarks"].as_array().is_some_and(|remarks| {
                remarks
                    .iter()
                    .any(|remark| remark.as_str().is_some_and(|text| text.starts_with("no flutter")))
            });
            assert_eq!(flutter.is_none(), said, "{model} {method}: {numbers}");
            assert_eq!(flutter.is_some(), numbers["flutter_frequency_hz"].is_number());
            assert!(out.join(format!("{model}_{method}.csv")).is_file());
        }
        assert!(out.join(format!("{model}.svg")).is_file());
        let divergence = |method: &str| result[model][method]["divergence_speed_m_s"].as_f64();
        let (exact, modal) = (divergence("state_matrix"), divergence("p_k"));
        let (exact, modal) =
            (exact.expect("a straight wing diverges"), modal.expect("with twenty modes too"));
        assert!((modal / exact - 1.0).abs() < 1e-3, "{model}: {exact} {modal}");
    }
    std::fs::remove_dir_all(&out).expect("our own folder");
}

/// A rigid section of one strip on springs of heave and pitch, in steady air at each end.
const SECTION: &str = "SOL 145\nCEND\nSPC = 1\nMETHOD = 5\nSUBCASE 3\nLABEL = a section\nFMETHOD = 6\nBEGIN BULK\n\
    GRID,1,,.4,0.,0.\nGRID,2,,.5,0.,0.\nGRID,3,,.4,2.,0.\nGRID,4,,.9,2.,0.\nRBE2,9,1,123456,2,3,4\n\
    CONM2,10,2,,4.\n,.1,,.1,,,.1\nCELAS2,1,4000.,1,3\nCELAS2,2,300.,1,5\nSPC1,1,1246,1\nEIGRL,5,,,2\n\
    AERO,0,,1.,1.225,1\nCAERO1,1001,1,,4,4,,,1\n,0.,0.,0.,1.,0.,2.,0.,1.\nPAERO1,1\nSET1,30,1,THRU,4\n\
    SPLINE1,20,1001,1001,1016,30\nMKAERO1,0.\n,.01,.05,.1,.2,.5,1.,2.\nFLUTTER,6,PK,1,2,3\nFLFACT,1,1.\nFLFACT,2,0.\n\
    FLFACT,3,5.,10.,15.,20.,25.,30.\n,35.,40.\nENDDATA\n";

#[test]
fn a_deck_is_run_as_it_stands_and_what_it_lacks_is_said() {
    let folder = std::env::temp_dir().join(format!("wingroot-flutter-deck-{}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("a temporary folder");
    let run = |deck: &str, more: &[&str]| {
        std::fs::write(folder.join("section.bdf"), deck).expect("a deck");
        let mut command = Command::new(env!("CARGO_BIN_EXE_wingroot"));
        command.args(["flutter", "--deck", "section.bdf", "--out", "out", "--json", "--quiet"]).args(more);
        command.current_dir(&folder).output().expect("the command starts")
    };
    let output = run(SECTION, &[]);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let result: Value = serde_json::from_slice(&output.stdout).expect("nothing but JSON");
    let case = &result["subcases"][0];
    assert_eq!(
        (case["subcase"].as_u64(), case["boxes"].as_u64(), case["label"].as_str()),
        (Some(3), Some(16), Some("a section"))
    );
    // sqrt(k/m) of heave and pitch about the spring, coupled by the mass 0.1 behind it.
    let (m, s, i) = (4.0, 0.4, 0.1 + 0.04);
    let (kh, kp) = (4000.0, 300.0);
    let (a, b, c) = (m * i - s * s, -(m * kp + i * kh), kh * kp);
    for (at, sign) in [(0, -1.0), (1, 1.0)] {
        let square: f64 = (-b + sign * f64::sqrt(b * b - 4.0 * a * c)) / (2.0 * a);
        let hz = case["frequencies_hz"][at].as_f64().expect("a frequency");
        assert!((hz * std::f64::consts::TAU / square.sqrt() - 1.0).abs() < 1e-6, "mode {at}: {hz} Hz");
    }
    let changes = case["conditions"][0]["changes_of_stability"].as_array().expect("a list");
    assert!(changes.iter().any(|change| change["becomes"] == "unstable"), "{changes:?}");
    let table = std::fs::read_to_string(folder.join("out/roots.csv")).expect("a table");
    assert!(table.lines().count() > 16, "two roots or more at eight airspeeds: {table}");
    assert!(
        folder.join("out/report.html").is_file() && folder.join("out/subcase_3_condition_1.svg").is_file()
    );
    for (deck, more, words) in [
        (SECTION.replace("FMETHOD = 6", "FMETHOD = 7"), &[][..], "FMETHOD 7, which is not there"),
        (SECTION.replace("AERO,0,,1.", "$"), &[], "no AERO"),
        (SECTION.replace("MKAERO1,0.", "MKAERO1,1.4"), &[], "1.4"),
        (SECTION.to_owned(), &["--subcase", "4"], "subcase 4 asks for no flutter"),
        (SECTION.replace("SPLINE1,20", "SPLINE6,20"), &[], "SPLINE6"),
    ] {
        let output = run(&deck, more);
        let said = String::from_utf8_lossy(&output.stderr).into_owned();
        assert!(matches!(output.status.code(), Some(2 | 3)), "{said}");
        assert!(said.contains(words), "{words}: {said}");
    }
    std::fs::remove_dir_all(&folder).expect("our own folder");
}

#[test]
fn roots_beyond_the_deck_s_frequencies_are_said_and_matched_points_have_their_mach_number() {
    let folder = std::env::temp_dir().join(format!("wingroot-flutter-beyond-{}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("a temporary folder");
    let run = |deck: &str, more: &[&str]| {
        std::fs::write(folder.join("section.bdf"), deck).expect("a deck");
        let mut command = Command::new(env!("CARGO_BIN_EXE_wingroot"));
        command.args(["flutter", "--deck", "section.bdf", "--out", "out", "--numbers-only"]).args(more);
        let output = command.current_dir(&folder).output().expect("the command starts");
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        String::from_utf8_lossy(&output.stdout).into_owned() + &String::from_utf8_lossy(&output.stderr)
    };
    let beyond = "beyond the reduced frequencies of MKAERO1 and MKAERO2";
    let long = SECTION.replace(",.01,.05,.1,.2,.5,1.,2.\n", ",.01,.05,.1,.2,.5,1.,2.,10.\n");
    assert!(!run(&long, &[]).contains(beyond));
    assert!(run(SECTION, &[]).contains("a flutter among them may be missed"));
    // its flutter at 21 m/s has k = .97: with k up to .5 it is found late, with k up to .05 not at all
    for (ks, words) in [
        (",.01,.05,.1,.2,.5\n", ["(highest k: 0.5), up to k = ", "rests on it: list higher k in MKAERO1"]),
        (
            ",.01,.05\n",
            ["(highest k: 0.05), up to k = ", "a flutter among them may be missed: list higher k"],
        ),
    ] {
        let said = run(&SECTION.replace(",.01,.05,.1,.2,.5,1.,2.\n", ks), &[]);
        for words in [&[beyond][..], &words].concat() {
            assert!(said.contains(words), "{words}: {said}");
        }
    }
    // the same air at eight matched points, whose Mach numbers rise by .02 from 5 m/s on
    let matched = SECTION
        .replace("MKAERO1,0.\n", "MKAERO1,0.,.14\n")
        .replace(
            "PK,1,2,3\nFLFACT,1,1.\nFLFACT,2,0.\n",
            "PKNL,1,2,3\nFLFACT,1,1.,1.,1.,1.,1.,1.,1.\n,1.\nFLFACT,2,0.,.02,.04,.06,.08,.1,.12\n,.14\n",
        )
        .replace(",30.\n,35.,40.\n", ",30.,35.\n,40.\n");
    let result: Value =
        serde_json::from_str(&run(&matched, &["--json", "--quiet"])).expect("nothing but JSON");
    let condition = &result["subcases"][0]["conditions"][0];
    assert_eq!(condition["machs"], serde_json::json!([0.0, 0.14]));
    let changes = condition["changes_of_stability"].as_array().expect("a list");
    assert!(!changes.is_empty());
    for change in changes {
        let [v, mach] = ["velocity", "mach"].map(|key| change[key].as_f64().expect("a number"));
        assert!((mach - 0.004 * (v - 5.0)).abs() < 1e-12, "{change}");
    }
    assert!(run(&matched, &[]).contains(&format!("{:.4}", changes[0]["mach"].as_f64().expect("a number"))));
    std::fs::remove_dir_all(&folder).expect("our own folder");
}

/// The wing of `data/pazy` on few boxes.
fn few_boxes(folder: &Path, more: &str) {
    let data = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/pazy");
    std::fs::create_dir_all(folder).expect("a temporary folder");
    let wing = std::fs::read_to_string(data.join("wing.ron")).expect("a shipped file");
    let wing = wing.replace("chordwise: 18, spanwise: 36", "chordwise: 4, spanwise: 12");
    let wing = wing.replace("    name: \"Pazy wing\",", &format!("    name: \"Pazy wing\",{more}"));
    std::fs::write(folder.join("wing.ron"), wing).expect("a file");
    std::fs::copy(data.join("beam_distribution.csv"), folder.join("beam_distribution.csv")).expect("a copy");
}

#[test]
fn a_wing_that_bends_has_a_hump_that_small_deflections_do_not_know() {
    let folder = std::env::temp_dir().join(format!("wingroot-flutter-bent-{}", std::process::id()));
    few_boxes(&folder, "\n    geometry: Nonlinear,");
    let run = |arguments: &[&str]| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_wingroot"));
        command.args(["flutter", "--out", "out", "--json", "--quiet"]).args(arguments);
        command.current_dir(&folder).output().expect("the command starts")
    };
    let output = run(&["--alpha", "3", "--to", "64", "--step", "4"]);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let result: Value = serde_json::from_slice(&output.stdout).expect("nothing but JSON");
    let changes = result["root_angles"][0]["changes_of_stability"].as_array().expect("a list");
    let [onset, offset] = changes.as_slice() else { panic!("not one hump: {changes:?}") };
    assert_eq!((&onset["becomes"], &offset["becomes"]), (&"unstable".into(), &"stable".into()));
    // Measured 49 and 55 m/s (`crates/maneuver/tests/bent_flutter.rs` compares the fine mesh); the undeformed wing has none below 64.
    let v = |change: &Value| change["V_m_s"].as_f64().expect("a number");
    assert!((v(onset) / 49.0 - 1.0).abs() < 0.1 && v(offset) < 64.0, "{changes:?}");
    assert!(result["linear"]["flutter_speed_m_s"].is_null(), "{}", result["linear"]);
    assert!(folder.join("out/roots.csv").is_file() && folder.join("out/flutter_boundary.svg").is_file());
    // A sweep that begins inside the hump does not know where it began, and does not call that no flutter.
    let middle = format!("{:.1}", 0.5 * (v(onset) + v(offset)));
    let output = run(&["--alpha", "3", "--to", &middle, "--step", &middle]);
    let result: Value = serde_json::from_slice(&output.stdout).expect("nothing but JSON");
    let angle = &result["root_angles"][0];
    assert_eq!(angle["is_unstable_at_lowest_airspeed"], true, "{angle}");
    assert!(angle["remarks"].to_string().contains(&format!("unstable at {middle} m/s already")), "{angle}");
    assert!(!angle["remarks"].to_string().contains("no flutter"), "{angle}");
    // What small deflections have no use for is refused.
    few_boxes(&folder, "");
    let output = run(&["--alpha", "3"]);
    assert_eq!(output.status.code(), Some(2), "{}", String::from_utf8_lossy(&output.stderr));
    assert!(String::from_utf8_lossy(&output.stderr).contains("--nonlinear"));
    std::fs::remove_dir_all(&folder).expect("our own folder");
}
