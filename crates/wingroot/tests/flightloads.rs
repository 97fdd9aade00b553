//! `flightloads` on the shipped measurements, as a user runs it.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use serde_json::Value;

fn data(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data").join(name)
}

fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("flightloads_{name}"));
    std::fs::create_dir_all(&folder).expect("a temporary folder");
    folder
}

fn run(folder: &Path, measured: &Path) -> Output {
    Command::new(env!("CARGO_BIN_EXE_wingroot"))
        .args(["flightloads", "--json", "--quiet", "--out", "out", "--measured"])
        .arg(measured)
        .current_dir(folder)
        .output()
        .expect("the command starts")
}

fn result(name: &str, measured: &Path) -> (PathBuf, Value) {
    let folder = folder(name);
    let output = run(&folder, measured);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    (folder, serde_json::from_slice(&output.stdout).expect("JSON"))
}

fn row<'a>(result: &'a Value, load: &str, model: &str) -> &'a Value {
    let rows = result["rows"].as_array().expect("rows");
    rows.iter().find(|row| row["load"] == load && row["model"] == model).expect("a row")
}

fn holds_one(row: &Value) -> bool {
    let end = |name: &str| row["line"]["slope"][name].as_f64().expect("a slope");
    end("low") <= 1.0 && end("high") >= 1.0
}

#[test]
fn in_the_virtual_tunnel_one_is_in_the_interval_of_the_updated_slope_of_root_mx_and_not_of_the_initial() {
    let (folder, result) = result("tuflex", &data("tuflex"));
    let [initial, updated] = ["initial", "updated"].map(|model| row(&result, "Mx", model));
    assert!(holds_one(updated), "{updated}");
    assert!(!holds_one(initial), "{initial}");
    assert_eq!(updated["verdict"], "reliable", "{updated}");
    // Two of five angles at five airspeeds are judged, three times each; three angles fitted the corrections.
    assert_eq!((&updated["points"], &updated["fitted"]), (&30.into(), &45.into()));
    let page = std::fs::read_to_string(folder.join("out/report.html")).expect("a page");
    assert!(page.contains("reliable") && page.contains("compliance is the applicant"));
}

#[test]
fn the_swept_wing_has_a_verdict_for_each_load_with_the_reason_that_two_angles_are_too_few() {
    let (folder, result) = result("swept", &data("weber_brebner/flight.ron"));
    for load in ["Fz", "Mx"] {
        let row = row(&result, load, "updated");
        assert_eq!(row["verdict"], "undetermined", "{row}");
        assert!(row["reasons"][0].as_str().expect("a reason").starts_with("2 points"), "{row}");
        let ratio = row["worst_ratio"].as_f64().expect("a ratio");
        assert!((ratio - 1.0).abs() < 0.03, "the angles between are met within 3 %: {row}");
    }
    let page = std::fs::read_to_string(folder.join("out/report.html")).expect("a page");
    assert!(page.contains("undetermined") && page.contains("2 points"));
}

#[test]
fn tables_with_calculated_loads_need_no_wing_and_mistakes_end_with_status_two() {
    let folder = folder("tables");
    let file = r#"FlightLoads(name: "rolls", stations: [(name: "half", loads: [(load: Mx, sigma: 1.0)])],
        conditions: [(name: "roll", points: "roll.csv")],
        reliable_within_percent: 5.0, bias_within_sigma: 2.0, large_from_percent: 60.0)"#;
    let table = |factor: f64| {
        let row = |at: i32| format!("{},{}\n", f64::from(20 * at), factor * f64::from(20 * at));
        format!("half_Mx_Nm,updated_half_Mx_Nm\n{}", (-5..=10).map(row).collect::<String>())
    };
    std::fs::write(folder.join("flight.ron"), file).expect("a file");
    std::fs::write(folder.join("roll.csv"), table(0.8)).expect("a file");
    let output = run(&folder, Path::new("flight.ron"));
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let result: Value = serde_json::from_slice(&output.stdout).expect("JSON");
    assert_eq!(row(&result, "Mx", "updated")["verdict"], "unconservative");
    assert_eq!(result["rows"].as_array().expect("rows").len(), 1, "no initial loads were given");
    for (text, words) in [
        (table(0.8).replace("updated_", "updatd_"), "no load was calculated"),
        (table(0.8).replace("200,", "NaN,"), "roll.csv"),
        ("half_Mx_Nm\n".into(), "no points"),
    ] {
        std::fs::write(folder.join("roll.csv"), text).expect("a file");
        let output = run(&folder, Path::new("flight.ron"));
        let said = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(2), "{said}");
        assert!(said.contains(words), "{said}");
    }
}
