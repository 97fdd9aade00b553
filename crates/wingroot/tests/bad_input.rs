//! Bad input that needs more than one change of the small example, of which the table in `hostile` consists: one clear error
//! with its place and a hint, exit status 2, nothing half-written, an earlier result left as it was.

use std::path::{Path, PathBuf};
use std::process::Command;

/// Broken copies of the shipped wing and campaign, and an earlier result.
struct Case {
    folder: PathBuf,
    earlier: String,
}

impl Case {
    fn new(name: &str) -> Self {
        let folder = std::env::temp_dir().join(format!("wingroot-bad-{}-{name}", std::process::id()));
        let data = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/tuflex");
        std::fs::create_dir_all(folder.join("campaign")).expect("a temporary folder");
        // The beam wing: a second less for each command.
        for (file, name) in [
            ("wing_beam.ron", "wing.ron"),
            ("e214.dat", "e214.dat"),
            ("beam_distribution.csv", "beam_distribution.csv"),
            ("aircraft.ron", "aircraft.ron"),
        ] {
            std::fs::copy(data.join(file), folder.join(name)).expect("a shipped file");
        }
        for file in ["campaign.ron", "static.csv", "aoa_2hz_30.csv"] {
            std::fs::copy(data.join("measured").join(file), folder.join("campaign").join(file))
                .expect("a shipped file");
        }
        let modes = Command::new(env!("CARGO_BIN_EXE_wingroot"))
            .args(["modes", "--out", "results/out", "--quiet", "--numbers-only"])
            .current_dir(&folder)
            .status();
        assert!(modes.expect("the command starts").success());
        let earlier = std::fs::read_to_string(folder.join("results/out/result.json")).expect("a result");
        Self { folder, earlier }
    }

    /// Rewrites a file of the case.
    fn change(&self, file: &str, change: impl Fn(&str) -> String) -> &Self {
        let path = self.folder.join(file);
        let text = std::fs::read_to_string(&path).expect("a file of the case");
        let changed = change(&text);
        assert_ne!(changed, text, "the change does nothing");
        std::fs::write(path, changed).expect("a temporary file");
        self
    }

    /// Runs a command on the case; it must fail with status 2 and say all of `expected`, with a hint.
    fn fails(&self, arguments: &[&str], expected: &[&str]) {
        let output = Command::new(env!("CARGO_BIN_EXE_wingroot"))
            .args(arguments)
            .args(["--out", "results/out"])
            .current_dir(&self.folder)
            .output()
            .expect("the command starts");
        let said = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(2), "{said}");
        for part in expected.iter().chain(&["hint: "]) {
            assert!(said.contains(part), "`{part}` is not in: {said}");
        }
        assert!(output.stdout.is_empty() && !said.contains("panicked"), "{said}");
        let left: Vec<_> =
            std::fs::read_dir(self.folder.join("results")).expect("its folder").flatten().collect();
        assert_eq!(left.len(), 1, "something half-written: {left:?}");
        let earlier =
            std::fs::read_to_string(self.folder.join("results/out/result.json")).expect("still there");
        assert_eq!(earlier, self.earlier);
    }

    fn calibrate_fails(&self, expected: &[&str]) {
        self.fails(&["calibrate", "--wing", "wing.ron", "--campaign", "campaign"], expected);
    }
}

impl Drop for Case {
    fn drop(&mut self) {
        // a folder that stays is only untidy
        let _ = std::fs::remove_dir_all(&self.folder);
    }
}

#[test]
fn an_airspeed_with_two_angles_is_refused_at_its_first_row() {
    let case = Case::new("angles");
    let kept = |line: &&str| !line.starts_with("30.00") || line.starts_with("30.00,-");
    case.change("campaign/static.csv", |text| {
        text.lines().filter(kept).map(|line| line.to_owned() + "\n").collect()
    });
    case.calibrate_fails(&[
        "static.csv:16:1: the airspeed 30 m/s has 2 different angle(s), at least three are needed",
    ]);
}

#[test]
fn an_airspeed_beyond_divergence_is_refused_with_the_divergence_speed() {
    let case = Case::new("divergence");
    let forward =
        |text: &str| text.replace("quarter_chord_sweep_deg: 20.0", "quarter_chord_sweep_deg: -30.0");
    case.change("wing.ron", forward);
    case.calibrate_fails(&["static.csv:21:1: the wing diverges at 34 m/s, its divergence speed is 32."]);
}

#[test]
fn a_run_that_moves_an_unknown_control_is_told_the_wings_own() {
    let case = Case::new("control");
    let flap = |text: &str| {
        text.lines()
            .enumerate()
            .map(|(i, line)| line.to_owned() + if i == 0 { ",delta_flap_deg\n" } else { ",1.0\n" })
            .collect()
    };
    case.change("campaign/aoa_2hz_30.csv", flap);
    case.fails(
        &["simulate", "--wing", "wing.ron", "--campaign", "campaign", "--run", "campaign/aoa_2hz_30.csv"],
        &["aoa_2hz_30.csv:1:46: ", "flap", "inner, middle, outer"],
    );
}

#[test]
fn corrections_of_another_wing_are_refused() {
    let case = Case::new("hash");
    let set = "Corrections(wing: \"other\", wing_hash: \"0000\", sets: [(V_m_s: 30.0, force: [1.0], moment: [1.0], pressure_offset: [0.0])])";
    std::fs::write(case.folder.join("corrections.ron"), set).expect("a temporary file");
    case.fails(
        &["fullaircraft", "--wing", "wing.ron", "--corrections", "corrections.ron"],
        &["corrections.ron", "another wing"],
    );
}

#[test]
fn a_number_that_cannot_be_is_refused_at_its_field() {
    let case = Case::new("density");
    case.change("campaign/campaign.ron", |text| text.replace("rho_kg_m3: 1.225", "rho_kg_m3: 0.0"));
    case.calibrate_fails(&["campaign.ron:4:5: rho_kg_m3"]);
    let case = Case::new("plane");
    case.change("wing.ron", |text| text.replace("Symmetric(-0.09)", "Symmetric(0.3)"));
    case.calibrate_fails(&["wing.ron:63:5: box ", "crosses the plane of symmetry y = 0.3 m"]);
    for (name, from, to, expected) in [
        ("tail-field", "span_m: 0.45", "spann_m: 0.45", ":9: there is no field `spann_m`"),
        ("speed", "(V_m_s: 37.0", "(V_m_s: -37.0", ":15: pull_up.V_m_s is -37"),
        ("tail-boxes", "spanwise: 12", "spanwise: 0", ":9: htp: boxes"),
        ("no-wing", "wing: \"wing.ron\"", "wing: \"wng.ron\"", ":11: the file wng.ron"),
    ] {
        let case = Case::new(name);
        case.change("aircraft.ron", |text| text.replace(from, to));
        // the line is counted, so that the shipped file may grow
        let text = std::fs::read_to_string(case.folder.join("aircraft.ron")).expect("a file of the case");
        let line = 1 + text.lines().position(|line| line.contains(to)).expect("the changed line");
        case.fails(
            &["fullaircraft", "--aircraft", "aircraft.ron"],
            &[&format!("aircraft.ron:{line}{expected}")],
        );
    }
}

#[test]
fn two_runs_of_one_name_would_overwrite_each_other() {
    let case = Case::new("twins");
    std::fs::copy(case.folder.join("campaign/aoa_2hz_30.csv"), case.folder.join("aoa_2hz_30.csv"))
        .expect("a temporary file");
    case.fails(
        &["simulate", "--run", "campaign/aoa_2hz_30.csv", "aoa_2hz_30.csv"],
        &["aoa_2hz_30.csv: this run has the same name as campaign/aoa_2hz_30.csv"],
    );
}

#[test]
fn results_replace_neither_a_file_nor_a_folder_of_something_else() {
    for name in ["out-file", "out-folder"] {
        let case = Case::new(name);
        // what stands in the way is no earlier result: the campaign's folder, the wing's file
        let target = if name == "out-file" { "wing.ron" } else { "campaign" };
        let output = Command::new(env!("CARGO_BIN_EXE_wingroot"))
            .args(["calibrate", "--wing", "wing.ron", "--campaign", "campaign", "--out", target])
            .current_dir(&case.folder)
            .output()
            .expect("the command starts");
        let said = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.code() == Some(2) && said.contains("hint: choose a new"), "{said}");
        assert!(case.folder.join("wing.ron").is_file() && case.folder.join("campaign/static.csv").is_file());
        let hidden = std::fs::read_dir(&case.folder).expect("its folder").flatten();
        assert!(hidden.into_iter().all(|entry| !entry.file_name().to_string_lossy().starts_with('.')));
    }
}

#[test]
fn bad_maneuvers_are_refused_by_name_and_place() {
    let good = std::fs::read_to_string(
        Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/tuflex/maneuvers/doublet.ron"),
    )
    .expect("a shipped maneuver");
    let line = |field: &str| {
        good.lines().position(|line| line.trim_start().starts_with(field)).expect("a field") + 1
    };
    for (name, from, to, place, said) in [
        ("length", "length_s: 3.0", "length_s: -3.0", line("length_s"), "the length -3.0 s"),
        (
            "frequency",
            "frequency_hz: 1.0, start",
            "frequency_hz: 150.0, start",
            line("Doublet(of: \"inner"),
            "half the sampling rate",
        ),
        ("surface", "of: \"inner\"", "of: \"iner\"", line("Doublet(of: \"inner"), "did you mean \"inner\"?"),
        (
            "limit",
            "height_deg: 15.0",
            "height_deg: 45.0",
            line("Doublet(of: \"inner"),
            "beyond 30 degrees (assumed",
        ),
        (
            "actuator",
            "actuator: Assumed",
            "actuator: None",
            line("Doublet(of: \"inner"),
            "there is no actuator",
        ),
    ] {
        let case = Case::new(&format!("maneuver-{name}"));
        std::fs::write(case.folder.join("maneuver.ron"), &good).expect("a temporary file");
        case.change("maneuver.ron", |text| text.replace(from, to));
        case.fails(
            &["simulate", "--wing", "wing.ron", "--campaign", "campaign", "--maneuver", "maneuver.ron"],
            &[&format!("maneuver.ron:{place}:"), said],
        );
    }
    // no corrections were found there
    let case = Case::new("maneuver-airspeed");
    std::fs::write(case.folder.join("maneuver.ron"), good.replace("V_m_s: 30.0", "V_m_s: 80.0"))
        .expect("a temporary file");
    case.fails(
        &["simulate", "--wing", "wing.ron", "--campaign", "campaign", "--maneuver", "maneuver.ron"],
        &["maneuver.ron: no corrections at 80 m/s"],
    );
}

#[test]
fn a_campaign_without_doublets_and_a_bad_deflection_table_are_refused() {
    let case = Case::new("no-doublets");
    case.change("campaign/campaign.ron", |text| {
        let keep = |line: &&str| !line.contains("(file:") || line.contains("aoa_2hz_30.csv");
        text.lines().filter(keep).collect::<Vec<_>>().join("\n")
    });
    case.fails(
        &["deflection", "--wing", "wing.ron", "--campaign", "campaign"],
        &["no run for training is a doublet"],
    );
    let table =
        "deflection: [(control: \"inner\", rows: [(V_m_s: 30.0, commanded_deg: [5.0], factor: [9.0])])],";
    case.change("wing.ron", |text| text.replace("effects: [],", &format!("effects: [],\n    {table}")));
    case.fails(
        &["simulate", "--wing", "wing.ron", "--campaign", "campaign"],
        &["wing.ron:", "a factor of 9.0000"],
    );
}
