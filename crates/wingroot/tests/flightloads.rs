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

/// Weber and Brebner's sections at 4.2 degrees, an angle that fitted nothing.
#[test]
fn each_section_of_the_swept_wing_is_a_station_with_a_verdict_and_its_reason() {
    let (folder, result) = result("sections", &data("weber_brebner/flight.ron"));
    let rows = result["rows"].as_array().expect("rows");
    let of = |model: &str, station: &str| {
        let own = |row: &&Value| row["station"] == station && row["model"] == model;
        rows.iter().find(own).unwrap_or_else(|| panic!("{model} at {station}"))
    };
    let table = read(&data("weber_brebner/strips.csv"));
    let sections: Vec<&str> = table
        .lines()
        .filter(|line| line.starts_with("49.7"))
        .map(|line| line.split(',').nth(2).expect("y"))
        .collect();
    assert_eq!(sections.len(), 10);
    let page = read(&folder.join("out/report.html"));
    for section in sections {
        let station = format!("2y/b {section}");
        for model in ["initial", "updated"] {
            let row = of(model, &station);
            assert_eq!(row["verdict"], "undetermined", "{row}");
            assert!(row["reasons"][0].as_str().expect("a reason").starts_with("1 point "), "{row}");
            let ratio = row["worst_ratio"].as_f64().expect("a ratio");
            assert!((0.8..1.1).contains(&ratio), "{station} {model}: {ratio}");
            // away from root and tip the model that met the root's loads meets the sections
            let inner =
                (0.05..0.7).contains(&section.parse::<f64>().expect("a number")) && model == "updated";
            assert!(!inner || (ratio - 1.0).abs() < 0.03, "{station}: {ratio}");
        }
        assert!(page.contains(&station), "{station}");
    }
    let all = of("updated", "all sections");
    assert_eq!(all["points"], 10);
    assert_ne!(all["verdict"], "unconservative", "{all}");
    // the sections' lift integrates to CL 0.23, the balance measured 0.238: measured on calculated
    let slope = all["line"]["slope"]["value"].as_f64().expect("a slope");
    assert!((slope - 0.23 / 0.238).abs() < 0.015, "{slope}");
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

/// A run of `loads` as far as coverage reads it.
const SELECTED: &str = "sid,model,case,instant,t_s,H_m,kind,mass,h_m,V_m_s,n_z,driven,limit,why\n\
                        1,updated,3,1,0,,corner,full,0,28.0,2.5,4,,\"ends, of Mx\"\n2,updated,9,4,0.2,12.5,discrete,full,0,46.0,1.0,2,,\"hull\"\n";
const ENVELOPE: &str = "model,station,load,end,value,case,flown\n\
                        initial,right half,Mx_Nm,largest,99,9,\"gust\"\nupdated,right half,Mx_Nm,smallest,-4,3,\"corner, down\"\n\
                        updated,right half,Mx_Nm,largest,20,9,\"gust\"\n";

#[test]
fn design_instants_and_loads_that_were_not_flown_are_said() {
    let folder = folder("coverage");
    let file = r#"FlightLoads(name: "pull-ups", stations: [(name: "half", loads: [(load: Mx, sigma: 1.0)])],
        conditions: [(name: "pull-up", points: "points.csv")],
        reliable_within_percent: 5.0, bias_within_sigma: 2.0, large_from_percent: 60.0)"#;
    let points = "V_m_s,n_z,half_Mx_Nm,updated_half_Mx_Nm\n20,1,4,4\n25,2,8,8.1\n30,2.6,10,10\n30,3,12.5,12.4\n30,0.5,2,2\n";
    let design = folder.join("design");
    std::fs::create_dir_all(&design).expect("a folder");
    for (path, text) in [
        (folder.join("flight.ron"), file),
        (folder.join("points.csv"), points),
        (design.join("selected.csv"), SELECTED),
        (design.join("envelope.csv"), ENVELOPE),
    ] {
        std::fs::write(path, text).expect("a file");
    }
    let run = |design: &Path| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_wingroot"));
        command.args(["flightloads", "--json", "--out", "out", "--measured", "flight.ron", "--package"]);
        command.arg(design).current_dir(&folder).output().expect("the command starts")
    };
    let output = run(&design);
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(output.status.success(), "{said}");
    let result: Value = serde_json::from_slice(&output.stdout).expect("JSON");
    let instants = result["coverage"]["instants"].as_array().expect("instants");
    let flown: Vec<[bool; 2]> = instants
        .iter()
        .map(|one| ["v_is_flown", "n_is_flown"].map(|key| one[key].as_bool().expect("it was recorded")))
        .collect();
    assert_eq!(flown, [[true, true], [false, true]], "28 m/s at 2.5 was flown, 46 m/s was not");
    let loads = read(&folder.join("out/coverage_loads.csv"));
    assert!(
        loads.contains("\"half\",Mx,largest,12.5,20,1.600000"),
        "20 N m by design, 12.5 measured: {loads}"
    );
    assert!(loads.contains("\"half\",Mx,smallest,2,-4,not flown"), "nothing downwards was measured: {loads}");
    std::fs::write(design.join("envelope.csv"), ENVELOPE.replace("right half", "right third"))
        .expect("a file");
    let output = run(&design);
    assert_eq!(output.status.code(), Some(2), "the plan has no such station");
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(said.contains("no design loads Mx_Nm of station half"), "{said}");
}

fn read(path: &Path) -> String {
    std::fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}
