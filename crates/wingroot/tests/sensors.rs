//! A campaign that fits the tip beside root loads: what its report says, that a command that calibrates on its way does as
//! `calibrate` does, and that the structure it tells flies. The example wing's generated campaign.

#![expect(clippy::unwrap_used, reason = "a helper of tests may fail the test where it stands")]

use std::path::{Path, PathBuf};
use std::process::Command;

use serde_json::Value;

/// A copy of the example wing whose campaign fits the tip, alone in a folder.
fn with_tip(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    std::fs::remove_dir_all(&folder).ok();
    std::fs::create_dir_all(&folder).unwrap();
    let (status, said) = run(&folder, &["new", "my_wing"]);
    assert_eq!(status, Some(0), "{said}");
    let path = folder.join("my_wing/campaign/campaign.ron");
    let text = std::fs::read_to_string(&path).unwrap();
    let changed = text
        .replace("    static_cases:", "    tip: Some(Zeroed),\n    static_cases:")
        .replace("mx_Nm: 0.008, my_Nm: 0.002)", "mx_Nm: 0.008, my_Nm: 0.002, tip_z_m: 0.0005)");
    assert!(changed.contains("Zeroed") && changed.contains("0.0005"), "the example has changed");
    std::fs::write(path, changed).unwrap();
    folder
}

fn run(folder: &Path, arguments: &[&str]) -> (Option<i32>, String) {
    let output =
        Command::new(env!("CARGO_BIN_EXE_wingroot")).args(arguments).current_dir(folder).output().unwrap();
    let said = [output.stdout, output.stderr].map(|text| String::from_utf8_lossy(&text).into_owned());
    (output.status.code(), said.concat())
}

fn result(folder: &Path, command: &str) -> Value {
    let path = folder.join("out").join(command).join("result.json");
    serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap()
}

/// Corrections show at few airspeeds and without intervals, too.
const FLUTTER: [&str; 5] = ["flutter", "--numbers-only", "--no-intervals", "--to", "20"];
const CAMPAIGN: [&str; 4] = ["--wing", "my_wing/wing.ron", "--campaign", "my_wing/campaign"];

#[test]
fn a_campaign_with_the_tip_has_the_same_corrections_in_every_command_and_says_where_they_come_from() {
    let folder = with_tip("sensors-tip");
    // first without corrections in the folder
    let (status, said) = run(&folder, &[&FLUTTER[..], &CAMPAIGN[..]].concat());
    assert_eq!(status, Some(0), "{said}");
    let found_now = result(&folder, "flutter");
    let (status, said) = run(&folder, &[&["calibrate"], &CAMPAIGN[..]].concat());
    assert_eq!(status, Some(0), "{said}");
    assert!(said.contains("PosteriorMean") && said.contains("14 m/s: flexibility"), "{said}");
    assert!(!said.contains("times its effect"), "no control was deflected: {said}");
    let page = std::fs::read_to_string(folder.join("out/calibrate/report.html")).unwrap();
    assert!(
        page.contains("are those that all measurements and the prior leave most likely"),
        "the page's lead"
    );
    assert!(!page.contains("as closely as a straight line"), "the page's lead");
    let (status, said) = run(&folder, &[&FLUTTER[..], &CAMPAIGN[..]].concat());
    assert_eq!(status, Some(0), "{said}");
    for key in ["initial", "updated"] {
        let again = result(&folder, "flutter");
        assert!(again[key].is_object() || again[key].is_array(), "{again}");
        assert_eq!(found_now[key], again[key], "{key}");
    }
}

/// A copy of the example wing whose beam is as soft as the logarithms of factors on its flexibility in bending and torsion say.
fn softer(folder: &Path, [bending, torsion]: [f64; 2]) {
    let to = folder.join("softer");
    std::fs::create_dir_all(&to).unwrap();
    for entry in std::fs::read_dir(folder.join("my_wing")).unwrap() {
        let from = entry.unwrap().path();
        if from.is_file() {
            std::fs::copy(&from, to.join(from.file_name().unwrap())).unwrap();
        }
    }
    let text = std::fs::read_to_string(to.join("beam.csv")).unwrap();
    let mut head: Vec<String> = Vec::new();
    let line = |line: &str| -> String {
        if line.starts_with('#') || head.is_empty() {
            if !line.starts_with('#') {
                head = line.split(',').map(str::to_owned).collect();
            }
            return line.to_owned();
        }
        let cell = |(name, cell): (&String, &str)| {
            let log = if name.starts_with("EI") {
                bending
            } else if name.starts_with("GJ") {
                torsion
            } else {
                return cell.to_owned();
            };
            format!("{:?}", cell.trim().parse::<f64>().unwrap() * (-log).exp())
        };
        head.iter().zip(line.split(',')).map(cell).collect::<Vec<_>>().join(",")
    };
    let softened: Vec<String> = text.lines().map(line).collect();
    assert_ne!(softened.join("\n"), text, "no stiffness was found in the table");
    std::fs::write(to.join("beam.csv"), softened.join("\n")).unwrap();
}

/// The updated aircraft flies the structure that the tip told: as the aircraft of a wing whose table of stiffness says so flies with the
/// corrections that go with it. The initial one flies the table as given.
#[test]
fn the_updated_aircraft_has_the_structure_that_was_found() {
    let folder = with_tip("sensors-found");
    let (status, said) = run(&folder, &[&["calibrate"], &CAMPAIGN[..]].concat());
    assert_eq!(status, Some(0), "{said}");
    let schedule = calibrate::Schedule::read(&folder.join("out/calibrate/corrections.ron")).unwrap();
    let found = schedule.found.clone().expect("the tip was fitted");
    assert!(found.log_flexibility[0].abs() > 0.01, "{:?}", found.log_flexibility);
    assert!(found.controls.iter().all(|factor| *factor == 1.0), "no control was deflected");
    let flown = |wing: &str, corrections: &str| -> (Value, String) {
        let aircraft = format!("{wing}/aircraft.ron");
        let arguments = [
            "fullaircraft",
            "--no-intervals",
            "--numbers-only",
            "--aircraft",
            &aircraft,
            "--corrections",
            corrections,
        ];
        let (status, said) = run(&folder, &arguments);
        assert_eq!(status, Some(0), "{said}");
        (result(&folder, "fullaircraft")["models"].take(), said)
    };
    let (models, said) = flown("my_wing", "out/calibrate/corrections.ron");
    assert!(said.contains("the updated model has the structure and surfaces that were found"), "{said}");

    softer(&folder, found.log_flexibility);
    let hash = coupling::WingFile::read(&folder.join("softer/wing.ron")).unwrap().hash;
    let own = calibrate::Schedule { wing_hash: hash, sets: found.sets, found: None, ..schedule.clone() };
    std::fs::write(folder.join("softer.ron"), own.to_ron()).unwrap();
    let (of_softer, said) = flown("softer", "softer.ron");
    assert!(!said.contains("that were found"), "{said}");
    let number = |models: &Value, place: &str| models.pointer(place).and_then(Value::as_f64).unwrap();
    for place in ["trim/alpha_deg", "pull_up/tip_deflection_m", "push_down/tip_deflection_m"] {
        let of = |models: &Value, model: &str| number(models, &format!("/{model}/{place}"));
        let off = of(&models, "updated") / of(&of_softer, "updated") - 1.0;
        assert!(off.abs() < 1e-4, "{place}: {off:e} from the wing that is as soft");
        let by_structure = of(&models, "initial") / of(&of_softer, "initial") - 1.0;
        assert!(by_structure.abs() > 10.0 * off.abs(), "{place}: initial {by_structure:e}");
    }
    let in_time = "/updated/doublet/peak_right_root_Mx_Nm";
    assert!((number(&models, in_time) / number(&of_softer, in_time) - 1.0).abs() < 1e-3);

    let given = calibrate::Schedule { found: None, ..schedule };
    std::fs::write(folder.join("given.ron"), given.to_ron()).unwrap();
    let (as_given, _) = flown("my_wing", "given.ron");
    assert_eq!(as_given["initial"], models["initial"]);
}
