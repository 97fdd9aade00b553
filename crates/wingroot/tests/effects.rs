//! `simulate` flies the effects of a wing's file; `--without` switches them off; `fullaircraft` says which of them fly.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

const EFFECTS: &str = r#"effects: [
    (name: "joiner_inertia", parameters: {"Iyy_kg_m2": 0.15}),
    (name: "ctl_saturation", parameters: {"inverse_s_inner_per_rad": 3.0, "inverse_s_outer_per_rad": 3.0}),
],"#;

fn data() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/tuflex")
}

fn wingroot(command: &str, wing: &Path, more: &[&str], out: &Path) -> Output {
    let mut line = Command::new(env!("CARGO_BIN_EXE_wingroot"));
    if command == "fullaircraft" {
        line.arg(command).arg("--aircraft").arg(data().join("aircraft.ron"));
    } else {
        line.arg(command);
    }
    line.args(["--json", "--numbers-only", "--wing"])
        .arg(wing)
        .arg("--campaign")
        .arg(data().join("measured"))
        .args(more)
        .arg("--out")
        .arg(out)
        .output()
        .expect("the command starts")
}

/// The shipped beam wing with other effects, in a folder of its own.
fn wing(folder: &Path, effects: &str) -> PathBuf {
    std::fs::create_dir_all(folder).expect("a folder");
    for file in ["e214.dat", "beam_distribution.csv"] {
        std::fs::copy(data().join(file), folder.join(file)).expect("a shipped file");
    }
    let text = std::fs::read_to_string(data().join("wing_beam.ron")).expect("the shipped wing");
    assert!(text.contains("effects: [],"));
    let path = folder.join("wing.ron");
    std::fs::write(&path, text.replace("effects: [],", effects)).expect("a file");
    path
}

#[test]
fn effects_fly_and_switched_off_they_leave_no_bit() {
    let folder = std::env::temp_dir().join(format!("wingroot-effects-{}", std::process::id()));
    let (plain, with) = (wing(&folder.join("plain"), "effects: [],"), wing(&folder.join("with"), EFFECTS));
    let maneuver = data().join("maneuvers/doublet.ron");
    let maneuver = maneuver.to_str().expect("a plain path");
    let flown = |wing: &Path, more: &[&str], out: &str| {
        let all = [&["--maneuver", maneuver], more].concat();
        let output = wingroot("simulate", wing, &all, &folder.join(out));
        let said = String::from_utf8_lossy(&output.stderr).into_owned();
        assert!(output.status.success(), "{said}");
        let loads = std::fs::read_to_string(folder.join(out).join("doublet.csv")).expect("a result");
        (loads, said, String::from_utf8_lossy(&output.stdout).into_owned())
    };
    let (clean, said, json) = flown(&plain, &[], "a");
    assert!(!said.contains("the wing's effects") && !json.contains("\"effects\""), "{said}");
    let (changed, said, json) = flown(&with, &[], "b");
    assert!(said.contains("joiner_inertia, ctl_saturation"), "{said}");
    assert!(json.contains("inverse_s_outer_per_rad") && changed != clean);
    let off = ["--without", "joiner_inertia", "--without", "ctl_saturation"];
    let (again, said, _) = flown(&with, &off, "c");
    assert!(said.contains("switched off: joiner_inertia, ctl_saturation"), "{said}");
    assert_eq!(again, clean);
    let refused =
        wingroot("simulate", &with, &["--maneuver", maneuver, "--without", "joiner"], &folder.join("d"));
    let said = String::from_utf8_lossy(&refused.stderr).into_owned();
    assert_eq!(refused.status.code(), Some(2), "{said}");
    assert!(said.contains("no effect \"joiner\" to switch off"), "{said}");
    std::fs::remove_dir_all(&folder).expect("our own folder");
}

/// Largest deflection of the aileron in a model's doublet, degrees.
fn largest(folder: &Path, model: &str) -> f64 {
    let text = std::fs::read_to_string(folder.join(format!("out/doublet_{model}.csv"))).expect("a result");
    let mut lines = text.lines().filter(|line| !line.starts_with('#'));
    let columns: Vec<&str> = lines.next().expect("a head").split(',').collect();
    let column = columns.iter().position(|name| name.starts_with("delta")).expect("the aileron");
    let values = lines.map(|line| line.split(',').nth(column).expect("a cell").parse::<f64>());
    values.map(|value| value.expect("a number").abs()).fold(0.0, f64::max)
}

#[test]
fn an_aircraft_s_ailerons_reach_as_far_as_the_deflection_correction_says() {
    let folder = std::env::temp_dir().join(format!("wingroot-deflection-aircraft-{}", std::process::id()));
    // at the trim's 25.7 m/s and 10 degrees: between two airspeeds, and beyond the last, whose factor stands
    for (rows, expected) in [
        (
            "(V_m_s: 25.0, commanded_deg: [5.0, 15.0], factor: [0.9, 0.7]), (V_m_s: 26.0, commanded_deg: [10.0], factor: [0.9])",
            0.87,
        ),
        (
            "(V_m_s: 18.0, commanded_deg: [10.0], factor: [0.9]), (V_m_s: 20.0, commanded_deg: [10.0], factor: [0.8])",
            0.8,
        ),
    ] {
        let with =
            wing(&folder.join("with"), &format!("deflection: [(control: \"outer\", rows: [{rows}])],"));
        let output = wingroot("fullaircraft", &with, &[], &folder.join("out"));
        let said = String::from_utf8_lossy(&output.stderr).into_owned();
        assert!(output.status.success(), "{said}");
        assert!(said.contains(&format!("makes {:.2} of the 10 degrees", 10.0 * expected)), "{said}");
        let share = largest(&folder, "updated") / largest(&folder, "initial");
        assert!((share - expected).abs() < 1e-3, "{share} {expected}");
    }
    std::fs::remove_dir_all(&folder).expect("our own folder");
}

#[test]
fn an_aircraft_takes_the_saturation_of_its_ailerons_and_leaves_the_joiner_in_the_tunnel() {
    let folder = std::env::temp_dir().join(format!("wingroot-effects-aircraft-{}", std::process::id()));
    let with = wing(&folder.join("with"), EFFECTS);
    let output = wingroot("fullaircraft", &with, &[], &folder.join("out"));
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(output.status.success(), "{said}");
    assert!(said.contains("ctl_saturation act on the updated aircraft"), "{said}");
    assert!(said.contains("joiner_inertia belong to tunnel"), "{said}");
    // tanh(3 x 10 deg)/3: the amplitude of the doublet, at the trim's airspeed with no power of it
    let expected = ((3.0 * 10.0_f64.to_radians()).tanh() / 3.0).to_degrees() / 10.0;
    let share = largest(&folder, "updated") / largest(&folder, "initial");
    assert!((share - expected).abs() < 1e-3, "{share} {expected}");
    std::fs::remove_dir_all(&folder).expect("our own folder");
}
