//! Units that were mistaken are suspected aloud, good ones are not; numbers that are none are refused with their place.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// The example of `new`, to be spoilt.
struct Case(PathBuf);

impl Case {
    fn new(name: &str) -> Self {
        let folder = std::env::temp_dir().join(format!("wingroot-units-{name}-{}", std::process::id()));
        std::fs::create_dir_all(&folder).expect("a temporary folder");
        let made =
            Command::new(env!("CARGO_BIN_EXE_wingroot")).args(["new", "w"]).current_dir(&folder).output();
        assert!(made.expect("it starts").status.success());
        Self(folder)
    }

    fn change(&self, file: &str, change: impl Fn(&str) -> String) {
        let path = self.0.join("w").join(file);
        let text = std::fs::read_to_string(&path).expect("a file of the example");
        let changed = change(&text);
        assert_ne!(changed, text, "the change does nothing");
        std::fs::write(path, changed).expect("a temporary file");
    }

    /// Multiplies a column of the static cases.
    fn scale(&self, column: &str, factor: f64) {
        self.change("campaign/static.csv", |text| {
            let header = text.lines().next().expect("a header");
            let place = header.split(',').position(|name| name == column).expect("the column");
            let scaled = |line: &str| {
                let mut cells: Vec<String> = line.split(',').map(str::to_owned).collect();
                cells[place] = format!("{:e}", factor * cells[place].parse::<f64>().expect("a number"));
                cells.join(",") + "\n"
            };
            std::iter::once(format!("{header}\n")).chain(text.lines().skip(1).map(scaled)).collect()
        });
    }

    fn calibrate(&self) -> Output {
        Command::new(env!("CARGO_BIN_EXE_wingroot"))
            .args([
                "calibrate",
                "--wing",
                "w/wing.ron",
                "--campaign",
                "w/campaign",
                "--numbers-only",
                "--out",
                "out",
            ])
            .current_dir(&self.0)
            .output()
            .expect("it starts")
    }

    fn warns(&self, expected: &str) {
        said_of(&self.calibrate(), expected);
    }
}

fn said_of(output: &Output, expected: &str) {
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(
        said.lines().any(|line| line.contains("WARN") && line.contains(expected)),
        "`{expected}` is not in: {said}"
    );
    assert!(!said.contains("panicked"), "{said}");
}

impl Drop for Case {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.0);
    }
}

#[test]
fn angles_in_radians_are_suspected() {
    let case = Case::new("radians");
    case.scale("alpha_deg", 1.0_f64.to_radians());
    case.warns("radians instead of degrees?");
}

#[test]
fn loads_in_other_units_are_suspected() {
    let case = Case::new("kilonewton");
    for column in ["Fz_N", "Mx_Nm", "My_Nm"] {
        case.scale(column, 1e-3);
    }
    case.warns("kN and kN m instead of N and N m?");
    let case = Case::new("millimetre-arm");
    case.scale("Mx_Nm", 1e3);
    case.warns("the moment in N mm instead of N m");
    let case = Case::new("sign");
    for column in ["Fz_N", "Mx_Nm", "My_Nm"] {
        case.scale(column, -1.0);
    }
    case.warns("the opposite sign?");
}

#[test]
fn airspeeds_in_kilometres_an_hour_are_suspected() {
    let case = Case::new("airspeed");
    case.scale("V_m_s", 3.6);
    case.warns("km/h instead of m/s");
}

#[test]
fn a_density_that_is_no_air_is_suspected() {
    let case = Case::new("density");
    case.change("campaign/campaign.ron", |text| text.replace("rho_kg_m3: 1.2,", "rho_kg_m3: 0.0012,"));
    case.warns("no gas that wings are tested in");
}

#[test]
fn a_tip_in_millimetres_is_suspected() {
    let case = Case::new("tip");
    case.scale("tip_z_m", 1e3);
    case.change("campaign/campaign.ron", |text| {
        let (start, rest) = text.split_once("    noise: Some((").expect("its noise");
        let (_, end) = rest.split_once("    )),\n").expect("its end");
        format!("{start}    noise: None,\n    tip: Zeroed,\n{end}")
    });
    case.warns("the tip's height in millimetres instead of metres?");
}

#[test]
fn a_run_with_deflections_in_radians_is_suspected_and_a_misspelt_surface_found() {
    let case = Case::new("run");
    assert!(case.calibrate().status.success());
    let run = "campaign/aileron_10_20.csv";
    let simulate = || {
        let output = Command::new(env!("CARGO_BIN_EXE_wingroot"))
            .args([
                "simulate",
                "--wing",
                "w/wing.ron",
                "--campaign",
                "w/campaign",
                "--corrections",
                "out/corrections.ron",
            ])
            .args(["--run", &format!("w/{run}"), "--out", "simulated"])
            .current_dir(&case.0)
            .output()
            .expect("it starts");
        String::from_utf8_lossy(&output.stderr).into_owned()
    };
    assert!(!simulate().contains("radians"));
    case.change(run, |text| {
        let header = text.lines().next().expect("a header");
        let place = header.split(',').position(|name| name == "delta_aileron_deg").expect("the column");
        let scaled = |line: &str| {
            let mut cells: Vec<String> = line.split(',').map(str::to_owned).collect();
            cells[place] = format!("{}", cells[place].parse::<f64>().expect("a number").to_radians());
            cells.join(",") + "\n"
        };
        std::iter::once(format!("{header}\n")).chain(text.lines().skip(1).map(scaled)).collect()
    });
    let said = simulate();
    assert!(said.contains("are its angles in radians instead of degrees?"), "{said}");
    case.change(run, |text| text.replace("delta_aileron_deg", "delta_ailerno_deg"));
    let said = simulate();
    assert!(said.contains("did you mean `delta_aileron_deg`?"), "{said}");
}

#[test]
fn masses_in_grams_are_suspected() {
    let case = Case::new("grams");
    case.change("wing.ron", |text| {
        text.replace("mass_kg: 0.02)", "mass_kg: 20.0)").replace("mass_kg: 0.005)", "mass_kg: 5.0)")
    });
    case.warns("in grams instead of kg?");
}

#[test]
fn a_wing_in_millimetres_is_suspected() {
    let case = Case::new("millimetres");
    case.change("wing.ron", |text| {
        let (start, rest) = text.split_once("        structure: Beam((").expect("its structure");
        let (_, end) = rest.split_once("        )),\n").expect("its end");
        format!("{start}{end}")
            .replace("semispan_m: 0.9", "semispan_m: 900.0")
            .replace("root_chord_m: 0.24", "root_chord_m: 240.0")
            .replace("tip_chord_m: 0.14", "tip_chord_m: 140.0")
    });
    case.warns("are lengths in millimetres instead of metres?");
}

#[test]
fn a_deck_with_grids_in_millimetres_and_boxes_in_metres_is_suspected() {
    let case = Case::new("deck");
    std::fs::write(
        case.0.join("w/wing.bdf"),
        "GRID,1,,60.,0.,0.\nGRID,2,,60.,450.,0.\nGRID,3,,60.,900.,0.\nSPC1,1,123456,1\nSET1,1,1,2,3\n\
         CBAR,1,1,1,2,0.,0.,1.\nCBAR,2,1,2,3,0.,0.,1.\nPBAR,1,1,100.,1.+4,1.+4,1.+4\nMAT1,1,7.+4,2.7+4,,2.7-9\n\
         PAERO1,1\nCAERO1,1001,1,,8,4\n,0.,0.,0.,.2,0.,.9,0.,.2\n",
    )
    .expect("a deck");
    std::fs::write(
        case.0.join("w/wing.ron"),
        "Wing(name: \"deck\", source: Deck((file: \"wing.bdf\", spline_set: 1)), root_plane: Symmetric(0.0), \
         balance: (x_m: 0.05, y_m: 0.0, z_m: 0.0), correction: (chord_strips: 1, span_order: 1))",
    )
    .expect("a wing");
    case.warns("a thousandfold apart");
    case.warns("softer than rubber: is it in MPa or GPa instead of Pa?");
    case.warns("lighter than foam");
    // whatever is computed with it, and whether or not it carries its own weight
    let statics = Command::new(env!("CARGO_BIN_EXE_wingroot"))
        .args(["statics", "--nonlinear", "--wing"])
        .arg(case.0.join("w/wing.ron"))
        .arg("--out")
        .arg(case.0.join("out"))
        .output()
        .expect("the command starts");
    said_of(&statics, "softer than rubber");
}

#[test]
fn good_units_are_not_suspected() {
    let data = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data");
    let out = std::env::temp_dir().join(format!("wingroot-units-good-{}", std::process::id()));
    for (wing, campaign) in [
        ("own_wing/wing.ron", "own_wing/campaign"),
        ("pazy/wing.ron", "pazy/tip_3deg"),
        ("pazy/wing.ron", "pazy/tip_5deg"),
        ("weber_brebner/wing.ron", "weber_brebner"),
        ("tuflex/wing_beam.ron", "tuflex/measured"),
        ("tuflex/wing.ron", "tuflex/measured"),
    ] {
        let output = Command::new(env!("CARGO_BIN_EXE_wingroot"))
            .arg("calibrate")
            .args([
                "--wing".as_ref(),
                data.join(wing).as_os_str(),
                "--campaign".as_ref(),
                data.join(campaign).as_os_str(),
            ])
            .args(["--out".as_ref(), out.as_os_str()])
            .output()
            .expect("it starts");
        let said = String::from_utf8_lossy(&output.stderr).into_owned();
        assert!(output.status.success() && !said.contains("WARN"), "{wing}, {campaign}: {said}");
    }
    std::fs::remove_dir_all(&out).expect("the temporary folder");
}

#[test]
fn numbers_that_are_not_finite_are_refused_with_their_place() {
    for word in ["NaN", "inf", "-inf", "1e400"] {
        for (file, old, place) in [
            ("wing.ron", "damping_ratio: 0.015", "wing.ron:"),
            ("wing.ron", "y_m: 0.65", "wing.ron:"),
            ("campaign/campaign.ron", "rho_kg_m3: 1.2", "campaign.ron:5:16"),
            ("campaign/static.csv", "0.00,-4.00", "static.csv:2:6"),
            ("beam.csv", "0.0,46.0", "beam.csv:"),
        ] {
            let case = Case::new(&format!("finite-{}-{word}", file.replace('/', "-")));
            let separator = if old.contains(": ") { ": " } else { "," };
            let (before, _) = old.split_once(separator).expect("a separator");
            case.change(file, |text| text.replacen(old, &format!("{before}{separator}{word}"), 1));
            let output = case.calibrate();
            let said = String::from_utf8_lossy(&output.stderr).into_owned();
            assert_eq!(output.status.code(), Some(2), "{file}, {word}: {said}");
            assert!(said.contains(place) && said.contains("finite"), "{file}, {word}: {said}");
            assert!(!case.0.join("out").exists());
        }
        let case = Case::new(&format!("finite-deck-{word}"));
        std::fs::write(case.0.join("w/wing.bdf"), format!("GRID,1,,0.,{word},0.\n")).expect("a deck");
        let output = Command::new(env!("CARGO_BIN_EXE_wingroot"))
            .args(["modes", "--deck", "w/wing.bdf", "--out", "out"])
            .current_dir(&case.0)
            .output()
            .expect("it starts");
        let said = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(2), "{said}");
        assert!(said.contains("wing.bdf:1:12"), "{said}");
    }
}
