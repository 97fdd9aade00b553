//! `modes`, `modes --measured`, `deck` and `validate` as a user runs them.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use serde_json::Value;

fn folder(name: &str) -> PathBuf {
    let folder = std::env::temp_dir().join(format!("wingroot-structure-{}-{name}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("a temporary folder");
    folder
}

fn run(folder: &Path, arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_wingroot"));
    command.args(arguments).args(["--quiet", "--out"]).arg(folder.join("out"));
    command.current_dir(folder).output().expect("the command starts")
}

fn result(folder: &Path, arguments: &[&str]) -> Value {
    let output = run(folder, arguments);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let text = std::fs::read_to_string(folder.join("out/result.json")).expect("a result");
    serde_json::from_str(&text).expect("JSON")
}

/// The beam wing.
fn wing(folder: &Path) -> PathBuf {
    let data = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/tuflex");
    for file in ["e214.dat", "beam_distribution.csv"] {
        std::fs::copy(data.join(file), folder.join(file)).expect("a shipped file");
    }
    std::fs::copy(data.join("wing_beam.ron"), folder.join("wing.ron")).expect("a shipped file");
    folder.join("wing.ron")
}

#[test]
fn modes_writes_frequencies_and_a_picture_of_each_shape() {
    let folder = folder("modes");
    wing(&folder);
    let result = result(&folder, &["modes", "--wing", "wing.ron", "--count", "4"]);
    let hertz: Vec<f64> =
        result["frequencies_hz"].as_array().expect("a list").iter().filter_map(Value::as_f64).collect();
    // The documented frequencies of the stand-in: 4.56, 20.4, 30.3, 51.4 Hz, to the 3 % of that comparison.
    for (got, want) in hertz.iter().zip([4.56, 20.4, 30.3, 51.4]) {
        assert!((got / want - 1.0).abs() < 0.03, "{got} Hz instead of {want}");
    }
    assert_eq!(hertz.len(), 4);
    assert!((result["mass_kg"].as_f64().expect("a number") - 2.2).abs() < 0.01);
    assert_eq!(result["elements"]["CBEAM"], 36);
    for mode in 1..=4 {
        let text = std::fs::read_to_string(folder.join(format!("out/mode_{mode:02}.vtu"))).expect("a shape");
        assert!(text.contains(&format!("NumberOfPoints=\"{}\"", result["grids"])));
    }
    std::fs::remove_dir_all(folder).expect("it was made above");
}

#[test]
fn numbers_alone_are_the_same_numbers() {
    let folder = folder("numbers-only");
    wing(&folder);
    let files = || -> BTreeSet<String> {
        let entries = std::fs::read_dir(folder.join("out")).expect("results").flatten();
        entries.map(|entry| entry.file_name().to_string_lossy().into_owned()).collect()
    };
    let modes = ["modes", "--wing", "wing.ron", "--count", "2"];
    let (with_pages, all) = (result(&folder, &modes), files());
    let (alone, left) = (result(&folder, &[&modes[..], &["--numbers-only"]].concat()), files());
    assert_eq!(alone["frequencies_hz"], with_pages["frequencies_hz"]);
    let gone: Vec<&str> = all.difference(&left).map(String::as_str).collect();
    assert_eq!(
        gone,
        ["report.html", "shapes.png", "shapes.svg", "shapes_in_space.png", "shapes_in_space.svg"]
    );
    assert!(left.is_subset(&all) && left.contains("mode_02.vtu") && left.contains("shapes_curves.csv"));
    // a command whose results are pages
    let refused = run(&folder, &["docs", "--numbers-only"]);
    let said = String::from_utf8_lossy(&refused.stderr).into_owned();
    assert!(refused.status.code() == Some(2) && said.contains("`docs` are pages"), "{said}");
    assert_eq!(files(), left);
    std::fs::remove_dir_all(folder).expect("it was made above");
}

#[test]
fn measured_frequencies_make_the_wing_softer_and_say_what_stays_open() {
    let folder = folder("measured");
    wing(&folder);
    // All frequencies 5 % below the model's: the ratio of stiffness to mass is 0.9025, and nothing tells the two apart.
    let model = result(&folder, &["modes", "--wing", "wing.ron", "--count", "3"]);
    let modes: Vec<String> = (0..3)
        .map(|mode| {
            let hertz = 0.95 * model["frequencies_hz"][mode].as_f64().expect("a number");
            format!("(frequency_hz: {hertz:?}, sigma_hz: 0.01)")
        })
        .collect();
    let file = |fit: &str| {
        format!(
            "Measured(modes: [{}], regions: [(name: \"all\", y_m: (-1.0, 2.0), fit: [{fit}])])",
            modes.join(", ")
        )
    };
    let arguments = ["modes", "--wing", "wing.ron", "--measured", "measured.ron"];
    std::fs::write(folder.join("measured.ron"), file("Stiffness")).expect("a temporary file");
    let fitted = result(&folder, &arguments);
    let factor = fitted["factors"][0]["value"].as_f64().expect("a number");
    assert!((factor - 0.9025).abs() < 1e-6, "{factor}");
    assert_eq!(fitted["factors"][0]["determined"], true);
    std::fs::write(folder.join("measured.ron"), file("Stiffness, Mass")).expect("a temporary file");
    let fitted = result(&folder, &arguments);
    assert!(fitted["factors"].as_array().expect("a list").iter().all(|factor| factor["determined"] == false));
    assert_eq!(fitted["undetermined"].as_array().expect("a list").len(), 1);
    // A grid that is not there: status 2, the earlier result stays.
    let bad =
        "Measured(modes: [(frequency_hz: 4.0, sigma_hz: 0.1, shape: [(grid: 9, component: 3, value: 1.0)])])";
    std::fs::write(folder.join("measured.ron"), bad).expect("a temporary file");
    let output = run(&folder, &arguments);
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(output.status.code(), Some(2), "{said}");
    assert!(said.contains("GRID 9 is not in the model") && said.contains("measured.ron:1:"), "{said}");
    assert!(folder.join("out/factors.ron").is_file());
    std::fs::remove_dir_all(folder).expect("it was made above");
}

#[test]
fn the_deck_has_the_modes_of_the_wing() {
    let folder = folder("deck");
    wing(&folder);
    let deck = result(&folder, &["deck", "--wing", "wing.ron", "--count", "5"]);
    std::fs::copy(folder.join("out/wing.bdf"), folder.join("wing.bdf")).expect("a temporary file");
    let modes = result(&folder, &["modes", "--deck", "wing.bdf", "--count", "5"]);
    assert_eq!(deck["boxes"], 708);
    for mode in 0..5 {
        let of = |result: &Value| result["frequencies_hz"][mode].as_f64().expect("a number");
        assert!((of(&deck) / of(&modes) - 1.0).abs() < 1e-8);
    }
    std::fs::remove_dir_all(folder).expect("it was made above");
}

/// What a deck leaves open is told: K6ROT of shells, and what AUTOSPC holds.
#[test]
fn what_is_assumed_of_a_deck_s_shells_is_said() {
    let folder = folder("k6rot");
    let head = "SOL 103\nCEND\nSPC = 1\nBEGIN BULK\nMAT1,1,7.+10,,.3,2700.\nSPC1,1,123456,1,4\n\
                GRID,1,,0.,0.,0.\nGRID,2,,1.,0.,0.\nGRID,3,,1.,1.,0.\nGRID,4,,0.,1.,0.\nPSHELL,1,1,.01,1,,1\nCQUAD4,1,1,1,2,3,4\n";
    let open = "rotations of flat shells about their normals get 100";
    for (parameter, said, unsaid) in [
        ("", open, "AUTOSPC holds"),
        ("PARAM,K6ROT,0.\n", "AUTOSPC holds 2 motion(s) without stiffness", open),
        ("PARAM,K6ROT,-1.\n", "PARAM K6ROT is -1", open),
    ] {
        std::fs::write(folder.join("deck.bdf"), format!("{head}{parameter}ENDDATA\n")).expect("a deck");
        let output = Command::new(env!("CARGO_BIN_EXE_wingroot"))
            .args(["modes", "--deck", "deck.bdf", "--count", "1", "--numbers-only", "--out", "out"])
            .current_dir(&folder)
            .output()
            .expect("the command starts");
        let text = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(if parameter.contains("-1") { 2 } else { 0 }), "{text}");
        assert!(text.contains(said) && !text.contains(unsaid), "{text}");
    }
    std::fs::remove_dir_all(folder).expect("it was made above");
}

/// Two masses on springs in a row (k 50, m 2): with the outer one alone kept, omega^2 = .4 k/m, in `modes` as in the modes of flutter.
#[test]
fn the_motions_that_a_deck_keeps_are_followed_and_said() {
    let folder = folder("reduction");
    let deck = "GRID,1,,.5,0.,0.\nGRID,2,,.5,1.,0.\nCELAS2,1,50.,1,3\nCELAS2,2,50.,1,3,2,3\nCMASS2,3,2.,1,3\nCMASS2,4,2.,2,3\nASET,2,3\n\
        AERO,,1.,1.,1.225\nCAERO1,101,9,,1,1,,,1\n,0.,0.,0.,1.,0.,1.,0.,1.\nPAERO1,9\nSPLINE2,5,101,101,101,7\nSET1,7,1,2\nMKAERO1,.0\n,.1,.5\n\
        FLUTTER,8,PK,11,12,13,L\nFLFACT,11,1.\nFLFACT,12,0.\nFLFACT,13,1.,2.\nEIGRL,6,,,1\n";
    std::fs::write(folder.join("modes.bdf"), deck).expect("a file");
    let solution = format!("SOL 145\nCEND\nMETHOD = 6\nFMETHOD = 8\nBEGIN BULK\n{deck}");
    std::fs::write(folder.join("flutter.bdf"), solution).expect("a file");
    let said = |arguments: &[&str]| {
        let output = Command::new(env!("CARGO_BIN_EXE_wingroot"))
            .args(arguments)
            .args(["--numbers-only", "--out", "out"])
            .current_dir(&folder)
            .output();
        let output = output.expect("the command starts");
        let text = String::from_utf8_lossy(&output.stderr).into_owned();
        let table = String::from_utf8_lossy(&output.stdout).into_owned();
        assert!(output.status.success(), "{text}");
        assert!(text.contains("modes are those of 1 of 2 motions, as ASET and OMIT say"), "{text}");
        let text = std::fs::read_to_string(folder.join("out/result.json")).expect("a result");
        (serde_json::from_str::<Value>(&text).expect("JSON"), table)
    };
    let hz = (0.4_f64 * 25.0).sqrt() / std::f64::consts::TAU;
    let (modes, table) = said(&["modes", "--deck", "modes.bdf"]);
    // (m + m/2)^2 / (m + m/4) of 2 m, all of them along z.
    assert!(table.lines().any(|row| row.split_whitespace().last() == Some("90.0")), "{table}");
    let found = modes["frequencies_hz"].as_array().expect("a list");
    assert_eq!(found.len(), 1);
    assert!((found[0].as_f64().expect("a number") / hz - 1.0).abs() < 1e-9, "{found:?}");
    let (flutter, _) = said(&["flutter", "--deck", "flutter.bdf"]);
    assert_eq!(flutter["subcases"][0]["frequencies_hz"], modes["frequencies_hz"]);
    std::fs::remove_dir_all(folder).expect("it was made above");
}

/// Two subcases of one structure, of which the second adds a spring to the equations of motion: it is refused, though the first has its modes.
#[test]
fn a_subcase_that_changes_the_equations_is_refused_beside_one_with_the_same_modes() {
    let folder = folder("direct");
    let deck = "SOL 145\nCEND\nMETHOD = 6\nSUBCASE 1\nFMETHOD = 8\nSUBCASE 2\nFMETHOD = 8\nK2PP = KX\nBEGIN BULK\n\
        GRID,1,,.5,0.,0.\nGRID,2,,.5,1.,0.\nCELAS2,1,50.,1,3\nCELAS2,2,50.,1,3,2,3\nCMASS2,3,2.,1,3\nCMASS2,4,2.,2,3\n\
        DMIG,KX,0,6,1,0\nDMIG,KX,2,3,,2,3,40.\nAERO,,1.,1.,1.225\nCAERO1,101,9,,1,1,,,1\n,0.,0.,0.,1.,0.,1.,0.,1.\nPAERO1,9\n\
        SPLINE2,5,101,101,101,7\nSET1,7,1,2\nMKAERO1,.0\n,.1,.5\nFLUTTER,8,PK,11,12,13,L\nFLFACT,11,1.\nFLFACT,12,0.\nFLFACT,13,1.,2.\nEIGRL,6,,,1\n";
    let flutter = |text: &str| {
        std::fs::write(folder.join("flutter.bdf"), text).expect("a file");
        run(&folder, &["flutter", "--deck", "flutter.bdf", "--numbers-only"])
    };
    let output = flutter(deck);
    let said = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{said}");
    assert!(said.contains("`K2PP = KX` changes the equations of motion"), "{said}");
    let plain = flutter(&deck.replace("K2PP = KX\n", ""));
    assert!(plain.status.success(), "{}", String::from_utf8_lossy(&plain.stderr));
    std::fs::remove_dir_all(folder).expect("it was made above");
}
