//! `calibrate` sets the spanwise lift beside measured strips, here those of Weber and Brebner (ARC R&M 2882).

use std::path::Path;
use std::process::{Command, Output};

fn calibrate(campaign: &Path, out: &Path) -> Output {
    let data = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/weber_brebner");
    Command::new(env!("CARGO_BIN_EXE_wingroot"))
        .args(["calibrate", "--json", "--wing"])
        .arg(data.join("wing.ron"))
        .arg("--campaign")
        .arg(campaign)
        .arg("--out")
        .arg(out)
        .output()
        .expect("the command starts")
}

#[test]
fn measured_strips_are_compared_and_a_misspelt_column_of_theirs_is_found() {
    let data = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/weber_brebner");
    let folder = std::env::temp_dir().join(format!("wingroot-strips-{}", std::process::id()));
    let output = calibrate(&data, &folder.join("out"));
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    assert!(folder.join("out/strips.svg").is_file());
    let result: serde_json::Value = serde_json::from_slice(&output.stdout).expect("nothing but JSON");
    assert!(result["strips_rms"]["note"].as_str().is_some_and(|note| note.contains("not used in the fit")));
    let rows = result["strips"].as_array().expect("a list");
    assert_eq!(rows.len(), 10);
    // the measured cl 0.235 at the root over CL = Fz/(q S) = 223.07/(1512.9 * 0.6195)
    assert!((rows[0]["measured_cl_over_CL"].as_f64().expect("a number") - 0.235 / 0.2380).abs() < 1e-3);
    let rms = |model: &str| result["strips_rms"][model].as_f64().expect("a number");
    assert!(
        rms("updated") < rms("initial"),
        "Fz and Mx (itself from the sections: the README) bring the span loading closer"
    );
    for file in ["campaign.ron", "static.csv"] {
        std::fs::copy(data.join(file), folder.join(file)).expect("a shipped file");
    }
    // without the strips the corrections are the same to the last letter: no fit reads them
    let output = calibrate(&folder, &folder.join("without"));
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let corrections =
        |out: &str| std::fs::read_to_string(folder.join(out).join("corrections.ron")).expect("a result");
    assert_eq!(corrections("out"), corrections("without"));
    assert!(!folder.join("without/strips.svg").exists());
    let text = std::fs::read_to_string(data.join("strips.csv")).expect("a shipped file");
    std::fs::write(folder.join("strips.csv"), text.replace("two_y_over_b", "two_y_overb")).expect("a file");
    let output = calibrate(&folder, &folder.join("out"));
    let said = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{said}");
    assert!(said.contains("strips.csv:2: ") && said.contains("is `two_y_overb` meant"), "{said}");
    std::fs::remove_dir_all(&folder).expect("our own folder");
}
