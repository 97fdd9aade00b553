//! Loads along the span, as a user asks for them: stations in the wing's file, strips on the command line.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

fn repository() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// The beam wing with `stations: [...]` in a folder of its own.
fn wing_with(stations: &str, folder: &Path) -> PathBuf {
    std::fs::create_dir_all(folder).expect("a folder");
    let data = repository().join("data/tuflex");
    for file in ["e214.dat", "beam_distribution.csv"] {
        std::fs::copy(data.join(file), folder.join(file)).expect("shipped");
    }
    let text = std::fs::read_to_string(data.join("wing_beam.ron")).expect("shipped");
    let end = text.rfind(')').expect("a closing parenthesis");
    let wing = folder.join("wing.ron");
    std::fs::write(&wing, format!("{}    stations: {stations},\n)\n", &text[..end])).expect("a file");
    wing
}

fn simulate(wing: &Path, out: &Path) -> Output {
    let run = "data/tuflex/measured/aoa_2hz_30.csv";
    Command::new(env!("CARGO_BIN_EXE_wingroot"))
        .args([
            "simulate",
            "--quiet",
            "--strips",
            "--campaign",
            "data/tuflex/measured",
            "--run",
            run,
            "--wing",
        ])
        .arg(wing)
        .arg("--out")
        .arg(out)
        .current_dir(repository())
        .output()
        .expect("the command starts")
}

#[test]
fn a_station_half_way_and_all_strips_have_columns_of_their_own() {
    let folder = std::env::temp_dir().join(format!("wingroot-stations-{}", std::process::id()));
    let wing = wing_with(r#"[(name: "half", y_m: 0.9)]"#, &folder);
    let output = simulate(&wing, &folder.join("out"));
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let read = |name: &str| std::fs::read_to_string(folder.join("out").join(name)).expect("written");
    let stations = read("aoa_2hz_30_stations.csv");
    let head = stations.lines().next().expect("a line");
    assert!(head.starts_with("t_s,Fz_half_N,Mx_half_Nm,My_half_Nm,lift_strip_1_N_m,"), "{head}");
    assert_eq!(head.split(',').count(), 1 + 3 + 56);
    // the run's own file can be flown again
    maneuver::Run::read(&folder.join("out/aoa_2hz_30.csv")).expect("a run's columns");
    let result: serde_json::Value = serde_json::from_str(&read("result.json")).expect("JSON");
    let fit = &result["air"]["largest_error_percent_by_load"];
    assert!(fit["Fz"].as_f64().expect("a number") < 1.0, "{fit}");
    std::fs::remove_dir_all(&folder).expect("our own folder");
}

#[test]
fn a_station_without_a_usable_name_is_refused_with_its_place() {
    for (stations, words) in [
        (r#"[(name: "half way", y_m: 0.9)]"#, "cannot be a column's"),
        (r#"[(name: "a", y_m: 0.9), (name: "a", y_m: 1.0)]"#, "two stations are called a"),
    ] {
        let folder = std::env::temp_dir().join(format!("wingroot-station-{}", std::process::id()));
        let wing = wing_with(stations, &folder);
        let output = simulate(&wing, &folder.join("out"));
        let said = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{said}");
        assert!(said.contains(words) && said.contains("wing.ron:"), "{said}");
        std::fs::remove_dir_all(&folder).expect("our own folder");
    }
}
