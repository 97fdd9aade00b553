//! A campaign that fits the tip beside root loads: what its report says, and that a command that calibrates on its way does as
//! `calibrate` does. The example wing's generated campaign.

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

const CAMPAIGN: [&str; 4] = ["--wing", "my_wing/wing.ron", "--campaign", "my_wing/campaign"];

#[test]
fn a_campaign_with_the_tip_has_the_same_corrections_in_every_command_and_says_where_they_come_from() {
    let folder = with_tip("sensors-tip");
    // first without corrections in the folder
    let (status, said) = run(&folder, &[&["flutter"], &CAMPAIGN[..]].concat());
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
    let (status, said) = run(&folder, &[&["flutter"], &CAMPAIGN[..]].concat());
    assert_eq!(status, Some(0), "{said}");
    for key in ["initial", "updated"] {
        let again = result(&folder, "flutter");
        assert!(again[key].is_object() || again[key].is_array(), "{again}");
        assert_eq!(found_now[key], again[key], "{key}");
    }
}
