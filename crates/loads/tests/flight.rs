//! Files of measured loads: what is read, and what is refused.

use loads::FlightFile;
use loads::flight::{Source, readings};
use std::path::{Path, PathBuf};

const FILE: &str = r#"FlightLoads(
    name: "two conditions",
    stations: [(name: "root", loads: [(load: Mx, sigma: 1.5, zero: Free)]), (name: "half", loads: [(load: Mx, sigma: 0.4)])],
    conditions: [(name: "pull-up", points: "pull_up.csv"), (name: "roll", history: "roll.csv", extremes: 1)],
    reliable_within_percent: 5.0, bias_within_sigma: 2.0, large_from_percent: 60.0, fitted: ["pull_up.csv"],
)"#;
const POINTS: &str = "V_m_s,alpha_deg,delta_outer_deg,n_z,Mx_Nm,half_Mx_Nm,initial_root_Mx_Nm,initial_half_Mx_Nm\n\
                      30,2,0,1,10,3,11,3.1\n30,4,5,2,20,6,22,6.2\n";
const ROLL: &str = "t_s,root_Mx_Nm,half_Mx_Nm\n0,0,5\n0.1,9,5\n0.2,40,6\n0.3,-20,30\n0.4,-3,1\n";

struct Folder(PathBuf);

impl Folder {
    fn new(name: &str) -> Self {
        let folder = std::env::temp_dir().join(format!("loads_flight_{name}_{}", std::process::id()));
        std::fs::create_dir_all(&folder).expect("a folder");
        Self(folder)
    }

    fn write(&self, name: &str, text: &str) -> PathBuf {
        let path = self.0.join(name);
        std::fs::write(&path, text).expect("a file");
        path
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        std::fs::remove_dir_all(&self.0).expect("it was made above");
    }
}

fn read(path: &Path) -> Result<usize, nastran::InputError> {
    let file = FlightFile::read(path)?;
    let mut count = 0;
    for condition in file.conditions()? {
        count += readings(&file, &condition)?.len();
    }
    Ok(count)
}

#[test]
fn points_bring_states_and_calculated_loads_and_histories_their_extremes() {
    let folder = Folder::new("read");
    let path = folder.write("flight.ron", FILE);
    folder.write("pull_up.csv", POINTS);
    folder.write("roll.csv", ROLL);
    let file = FlightFile::read(&path).unwrap();
    let conditions = file.conditions().unwrap();
    assert_eq!(conditions[1].source, Source::History("roll.csv".into(), 1));
    let points = readings(&file, &conditions[0]).unwrap();
    assert_eq!(points.len(), 2);
    assert!(points.iter().all(|point| point.fitted));
    assert_eq!(points[1].measured, [Some(20.0), Some(6.0)]);
    assert_eq!(points[1].calculated, [Some(vec![22.0, 6.2]), None]);
    let state = points[1].state.as_ref().unwrap();
    assert_eq!((state.v_m_s, state.alpha_deg, state.controls_deg["outer"]), (30.0, 4.0, 5.0));
    // The largest and the smallest of each: rows 2 and 3 of the root, 3 and 4 of half span.
    let roll = readings(&file, &conditions[1]).unwrap();
    let measured: Vec<_> = roll.iter().map(|reading| reading.measured.clone()).collect();
    assert_eq!(measured, [vec![Some(40.0), None], vec![Some(-20.0), Some(30.0)], vec![None, Some(1.0)]]);
    assert!(roll.iter().all(|reading| reading.state.is_none() && !reading.fitted));
}

#[test]
fn mistakes_are_refused_with_their_line() {
    let folder = Folder::new("refused");
    let check = |file: &str, points: &str, words: &str| {
        let path = folder.write("flight.ron", file);
        folder.write("pull_up.csv", points);
        folder.write("roll.csv", ROLL);
        let error = read(&path).unwrap_err();
        assert!(error.message.contains(words), "{error}");
        assert!(
            error.span.as_ref().is_some_and(|span| span.line > 0 || words.contains("no points")),
            "{error}"
        );
    };
    for (from, to, words) in [
        ("points: \"pull_up.csv\"", "extremes: 2", "has no points"),
        ("points: \"pull_up.csv\"", "points: \"pull_up.csv\", campaign: \"x\"", "two places"),
        ("load: Mx, sigma: 1.5", "load: Mw, sigma: 1.5", "Mw"),
        ("sigma: 1.5", "sigma: 0.0", "makes no sense"),
        ("name: \"half\"", "name: \"root\"", "there twice"),
        ("name: \"roll\"", "name: \"pull-up\"", "two conditions"),
        ("extremes: 1", "extremes: 0", "no extreme"),
        ("reliable_within_percent: 5.0", "reliable_within_percent: 0.0", "no threshold"),
        ("\"pull_up.csv\")", "\"pull_down.csv\")", "does not exist"),
    ] {
        check(&FILE.replacen(from, to, 1), POINTS, words);
    }
    check(FILE, &POINTS.replace("30,4,5,2,20", "30,4,5,2,NaN"), "NaN");
    check(FILE, &POINTS.replace("30,4", "0,4"), "no loads of the air");
    check(FILE, &POINTS.replace("half_Mx_Nm,initial_root", "half_Mx_Nm,initial_rot"), "initial_root_Mx_Nm");
    check(FILE, POINTS.lines().next().unwrap(), "no points");
}
