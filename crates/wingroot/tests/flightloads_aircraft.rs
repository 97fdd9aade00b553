//! `flightloads --aircraft`: a flight at the design states with exactly the design loads, Newton's law between load factors, and what is
//! refused.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use serde_json::Value;

const PLAN: &str = r#"Cases(
    name: "corners", rules: Vla, design_speeds_EAS_m_s: (VA: 34.0, VC: 37.0, VD: 46.0), limit_load_factors: (n1: 3.8, n2: -1.5),
    lift: (cl_max: 1.3, cl_min: -0.9), altitudes_m: [0.0], masses: [(name: "full", mass_kg: 20.0)],
    gusts: [Pratt(at: [VC, VD])], stations: [(name: "half", y_m: 0.9, x_m: 0.42)],
)
"#;
const FLIGHT: &str = r#"FlightLoads(name: "pull-ups",
    stations: [(name: "root", loads: [(load: Mx, sigma: 0.5)]), (name: "half", loads: [(load: Mx, sigma: 0.5)])],
    conditions: [(name: "pull-ups", points: "points.csv"), (name: "a pull-up in time", history: "history.csv", extremes: 1)],
    state_sigma: (V_m_s: 0.1), reliable_within_percent: 5.0, bias_within_sigma: 2.0, large_from_percent: 60.0)"#;

struct Folder(PathBuf);

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.0);
    }
}

impl Folder {
    fn write(&self, name: &str, text: &str) {
        std::fs::write(self.0.join(name), text).expect("a file of our own");
    }

    fn run(&self, words: &[&str]) -> Output {
        let mut command = Command::new(env!("CARGO_BIN_EXE_wingroot"));
        command.args(words).args(["--quiet", "--numbers-only", "--json"]).current_dir(&self.0);
        command.output().expect("the command starts")
    }

    fn judged(&self) -> Output {
        let words =
            ["flightloads", "--measured", "flight.ron", "--aircraft", "aircraft.ron", "--plan", "plan.ron"];
        self.run(&[&words[..], &["--out", "judged"]].concat())
    }
}

fn said(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

/// The shipped aircraft on beams, a plan of corners and gusts, and a flight of these states by a model of the plan.
fn flown(name: &str) -> Folder {
    let folder = std::env::temp_dir().join(format!("wingroot-flightloads-{name}-{}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("a folder of our own");
    let folder = Folder(folder);
    let data = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/tuflex").canonicalize().expect("data");
    let aircraft = std::fs::read_to_string(data.join("aircraft.ron")).expect("the shipped aircraft");
    let wing = format!("\"{}\"", data.join("wing_beam.ron").display());
    assert!(aircraft.contains("\"wing.ron\""));
    folder.write("aircraft.ron", &aircraft.replace("\"wing.ron\"", &wing));
    folder.write("plan.ron", PLAN);
    folder.write("flight.ron", FLIGHT);
    let words =
        ["loads", "--aircraft", "aircraft.ron", "--plan", "plan.ron", "--no-intervals", "--out", "design"];
    let output = folder.run(&words);
    assert!(output.status.success(), "{}", said(&output));
    folder
}

/// Rows of a table by its columns' names.
fn table(path: &Path) -> (Vec<String>, Vec<Vec<String>>) {
    let text = std::fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    let mut rows = text.lines().map(|line| line.split(',').map(str::to_owned).collect::<Vec<String>>());
    let head = rows.next().expect("heads");
    (head, rows.collect())
}

/// The states that were flown with their loads by the updated model, as a table of measurements, and how many.
fn measured(folder: &Folder) -> (String, usize) {
    let (_, cases) = table(&folder.0.join("design/cases.csv"));
    let (_, loads) = table(&folder.0.join("design/station_loads.csv"));
    let mx = |case: &str, station: &str| {
        let is = |row: &&Vec<String>| {
            row[0] == "updated" && row[1] == case && row[4] == station && row[5] == "net"
        };
        loads.iter().find(is).map(|row| row[9].clone()).expect("a row")
    };
    let mut points = String::from("V_m_s,n_z,root_Mx_Nm,half_Mx_Nm\n");
    let flown: Vec<&Vec<String>> = cases.iter().filter(|row| row[10] == "flown").collect();
    for row in &flown {
        let [root, half] = ["right root", "right half"].map(|station| mx(&row[0], station));
        // Writing to a String cannot fail.
        let _ = writeln!(points, "{},{},{root},{half}", row[4], row[7]);
    }
    (points, flown.len())
}

#[test]
fn a_flight_of_the_design_states_with_the_design_loads_is_reliable_with_a_slope_of_one() {
    let folder = flown("design");
    let (points, count) = measured(&folder);
    folder.write("points.csv", &points);
    // the same states one after the other
    let in_time =
        |(at, line): (usize, &str)| if at == 0 { format!("t_s,{line}\n") } else { format!("{at},{line}\n") };
    folder.write("history.csv", &points.lines().enumerate().map(in_time).collect::<String>());
    let output = folder.judged();
    assert!(output.status.success(), "{}", said(&output));
    let result: Value = serde_json::from_slice(&output.stdout).expect("JSON");
    let of = |condition: &str, station: &str, model: &str| {
        let keys = [("condition", condition), ("station", station), ("model", model)];
        let is = |row: &&Value| keys.iter().all(|(key, value)| row[key] == *value);
        let rows = result["rows"].as_array().expect("rows");
        rows.iter().find(is).unwrap_or_else(|| panic!("{condition} {station} {model}"))
    };
    for station in ["root", "half"] {
        let row = of("pull-ups", station, "updated");
        let slope = |row: &Value| row["line"]["slope"]["value"].as_f64().expect("a slope");
        // cases.csv has airspeeds and load factors to six digits behind the point
        assert!((slope(row) - 1.0).abs() < 1e-5 && row["verdict"] == "reliable", "{row}");
        assert_eq!(row["points"], count, "{row}");
        let worst = of("a pull-up in time", station, "updated")["worst_ratio"].as_f64().expect("a ratio");
        assert!((worst - 1.0).abs() < 1e-5, "{worst}");
        let initial = slope(of("pull-ups", station, "initial"));
        assert!((initial - 1.0).abs() > 0.01, "the initial model has other loads: {initial}");
    }
    refused(&folder, &points);
}

/// Two readings of a design load at an airspeed that is one and a half and three standard deviations too high.
const NOISY: &str = r#"FlightLoads(name: "noise", stations: [(name: "half", loads: [(load: Mx, sigma: 0.001)])],
    conditions: [(name: "chance", points: "chance.csv"), (name: "fault", points: "fault.csv")],
    state_sigma: (V_m_s: 0.3), reliable_within_percent: 0.01, bias_within_sigma: 2.0, large_from_percent: 60.0)"#;

#[test]
fn a_load_off_by_the_noise_of_the_airspeed_is_chance_and_one_off_by_twice_as_much_is_not() {
    // An airspeed k standard deviations off moves the calculated load by k of its own, whatever the aircraft. Beside nearly no noise of
    // the gauge 1.5 is no finding of two by Holm at 2.5 % and 3 is one; with half the noise both would be, with twice of it none.
    let folder = flown("noise");
    let (points, _) = measured(&folder);
    let corner = points.lines().find(|line| line.starts_with("37.000000,3.800000,")).expect("corner C");
    let half =
        corner.rsplit(',').next().expect("the moment at half of the span, which falls with the airspeed");
    for (name, v_m_s) in [("chance.csv", 37.0 + 1.5 * 0.3), ("fault.csv", 37.0 + 3.0 * 0.3)] {
        folder.write(name, &format!("V_m_s,n_z,half_Mx_Nm\n{v_m_s},3.8,{half}\n"));
    }
    folder.write("flight.ron", NOISY);
    let output = folder.judged();
    assert!(output.status.success(), "{}", said(&output));
    let result: Value = serde_json::from_slice(&output.stdout).expect("JSON");
    let rows = result["rows"].as_array().expect("rows").iter().filter(|row| row["model"] == "updated");
    let verdicts: Vec<(&Value, &Value)> = rows.map(|row| (&row["condition"], &row["verdict"])).collect();
    let [chance, fault] = verdicts[..] else { panic!("two rows: {verdicts:?}") };
    assert_eq!((chance.0.as_str(), chance.1.as_str()), (Some("chance"), Some("undetermined")), "one point");
    assert_eq!((fault.0.as_str(), fault.1.as_str()), (Some("fault"), Some("unconservative")));
}

/// Rolls, no load factor, a station that is not there, a wing in the tunnel beside the aircraft.
fn refused(folder: &Folder, points: &str) {
    let still = points.replace("V_m_s,", "delta_outer_deg,V_m_s,").replace('\n', "\n0,");
    let rolls = still.trim_end_matches("0,").replacen("\n0,", "\n5,", 1);
    let tunnel = FLIGHT.replace("state_sigma:", "wing: Some(\"wing.ron\"), state_sigma:");
    let third = [FLIGHT, points].map(|text| text.replace("half", "third"));
    for (changes, words) in [
        (vec![("points.csv", rolls)], "delta_outer_deg is not zero"),
        (vec![("points.csv", points.replace("n_z", "n_x"))], "no load factor"),
        (["flight.ron", "points.csv"].into_iter().zip(third).collect(), "no station third"),
        (vec![("flight.ron", tunnel)], "brings its own wing"),
    ] {
        for (file, text) in changes {
            folder.write(file, &text);
        }
        let output = folder.judged();
        assert_eq!(output.status.code(), Some(2), "{words}: {}", said(&output));
        assert!(said(&output).contains(words), "{words}: {}", said(&output));
        folder.write("points.csv", points);
        folder.write("flight.ron", FLIGHT);
    }
}
