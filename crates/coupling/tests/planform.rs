//! The parametric wing against the numbers of the wing it stands in for.
//!
//! Counts and dimensions are published ("Aeroelastic model update for a flexible wing using experimental data",
//! sections 1 and 2.2). Frequencies and tip flexibility are an own computation documented with the stand-in,
//! made by an independent program (data/tuflex/README.md).

use coupling::planform::{FIRST_AXIS_GRID, Mount, Planform};
use coupling::wing_file::WingFile;
use faer::Mat;
use nastran::{BulkData, CoordDefinition, Divisions};
use std::path::{Path, PathBuf};
use structure::{Flexibility, Model, System, normal_modes};

type Outcome = Result<(), Box<dyn std::error::Error>>;

fn data(file: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data").join(file)
}

fn tuflex() -> Result<WingFile, nastran::InputError> {
    WingFile::read(&data("tuflex/wing_beam.ron"))
}

fn planform(wing: &WingFile) -> &Planform {
    wing.planform().expect("data/tuflex/wing_beam.ron is a parametric wing")
}

fn box_counts(bulk: &BulkData) -> Vec<usize> {
    let number = |divisions| match divisions {
        Divisions::Equal(number) => number as usize,
        Divisions::Aefact(id) => bulk.factors[&id].values.len() - 1,
    };
    bulk.panels.values().map(|panel| number(panel.span_divisions) * number(panel.chord_divisions)).collect()
}

/// A copy of the wing's folder in which the wing file's text is edited; the temporary folder carries the test's
/// name, so tests do not meet.
fn edited(test: &str, from: &str, to: &str) -> Result<PathBuf, std::io::Error> {
    let folder = std::env::temp_dir().join(format!("wingroot_planform_{test}_{}", std::process::id()));
    std::fs::create_dir_all(&folder)?;
    for file in ["e214.dat", "beam_distribution.csv"] {
        std::fs::copy(data("tuflex").join(file), folder.join(file))?;
    }
    let text = std::fs::read_to_string(data("tuflex/wing_beam.ron"))?;
    assert!(text.contains(from), "the wing file does not contain {from}");
    let path = folder.join("wing.ron");
    std::fs::write(&path, text.replacen(from, to, 1))?;
    Ok(path)
}

/// The complaint about an edited wing file, with `file:line:column` cut off at the file's name.
fn complaint(test: &str, from: &str, to: &str) -> Result<String, Box<dyn std::error::Error>> {
    let path = edited(test, from, to)?;
    let outcome = WingFile::read(&path);
    std::fs::remove_dir_all(path.parent().expect("the file is in a folder"))?;
    let error = outcome.err().ok_or("the edited wing was accepted")?.to_string();
    Ok(error.split("wing.ron").skip(1).collect::<Vec<_>>().join("wing.ron"))
}

/// Line and column of `text` in the shipped wing file, edited.
fn place(from: &str, to: &str, anchor: &str) -> Result<String, std::io::Error> {
    let text = std::fs::read_to_string(data("tuflex/wing_beam.ron"))?.replacen(from, to, 1);
    let at = text.find(anchor).expect("the anchor is in the file");
    let line = text[..at].lines().count();
    let column = at - text[..at].rfind('\n').map_or(0, |newline| newline + 1) + 1;
    Ok(format!(":{line}:{column}:"))
}

#[test]
fn the_wing_has_672_boxes_and_the_fairing_36() -> Outcome {
    let wing = tuflex()?;
    assert_eq!(box_counts(&wing.bulk(Mount::Tunnel)?), [672, 36]);
    assert_eq!(box_counts(&wing.bulk(Mount::Aircraft)?), [672]);
    assert_eq!(wing.fairing_panel_ids(), [200_001]);
    assert_eq!(wing.bulk(Mount::Tunnel)?.matrices["W2GJ"].rows, 708);
    assert_eq!(wing.bulk(Mount::Aircraft)?.matrices["W2GJ"].rows, 672);
    Ok(())
}

#[test]
fn control_surface_edges_are_strip_edges_and_box_edges() -> Outcome {
    let wing = tuflex()?;
    let planform = planform(&wing);
    let bulk = wing.bulk(Mount::Tunnel)?;
    let edges_m = planform.strip_edges_m();
    // 25 to 50, 50 to 75 and 75 to 96.4 % of the half span; hinge at 75 % chord.
    for (id, (inboard, outboard)) in [(501, (0.25, 0.5)), (502, (0.5, 0.75)), (503, (0.75, 54.0 / 56.0))] {
        let boxes = &bulk.box_lists[&id].boxes;
        let strip = |number: u32| ((number - 100_001) / 12) as usize;
        let (first, last) = (strip(boxes[0]), strip(boxes[boxes.len() - 1]));
        assert_eq!(boxes.len(), 3 * (last - first + 1));
        assert!(boxes.iter().all(|number| (number - 100_001) % 12 >= 9), "a box ahead of the hinge");
        assert!(
            (edges_m[first] - inboard * 1.8).abs() < 1e-12
                && (edges_m[last + 1] - outboard * 1.8).abs() < 1e-12
        );
        let CoordDefinition::Points { a, b, c, .. } = &bulk.coords[&id].definition else {
            return Err("the hinge is a CORD2R".into());
        };
        let hinge = planform.point(inboard * 1.8, 0.75);
        assert!((a[0] - hinge.x).abs() < 1e-12 && (a[1] - hinge.y).abs() < 1e-12);
        // y = z cross x along the hinge line, toward the tip; z up.
        let z = [b[0] - a[0], b[1] - a[1], b[2] - a[2]];
        let x = [c[0] - a[0], c[1] - a[1], c[2] - a[2]];
        let y = [z[1] * x[2] - z[2] * x[1], z[2] * x[0] - z[0] * x[2]];
        let end = planform.point(outboard * 1.8, 0.75);
        let along = (end - hinge).normalize();
        assert!((z[2] - 1.0).abs() < 1e-12);
        assert!((y[0] - along.x).abs() < 1e-12 && (y[1] - along.y).abs() < 1e-12);
    }
    Ok(())
}

#[test]
fn area_and_both_aspect_ratios_are_the_published_ones() -> Outcome {
    let wing = tuflex()?;
    let planform = planform(&wing);
    assert!((planform.area_m2() - 0.405).abs() < 1e-12);
    assert!((planform.mean_chord_m() - 0.225).abs() < 1e-12);
    assert!((planform.half_wing_aspect_ratio() - 8.0).abs() < 1e-12);
    assert!((planform.full_wing_aspect_ratio() - 16.0).abs() < 1e-12);
    Ok(())
}

#[test]
fn the_published_box_rules_hold_for_the_wing_and_are_noticed_when_broken() -> Outcome {
    let wing = tuflex()?;
    let mut planform = planform(&wing).clone();
    assert!((planform.longest_box_m() - 0.0250).abs() < 1e-12);
    assert!((planform.largest_box_aspect_ratio() - 2.57).abs() < 0.005);
    assert!(planform.warnings(18.0, 50.0).is_empty());
    // 0.08 * 18 / 60 = 0.0240 m is less than the root's 0.0250 m.
    assert_eq!(planform.warnings(18.0, 60.0).len(), 1);
    planform.boxes.spanwise = 28;
    assert_eq!(planform.warnings(18.0, 50.0).len(), 1);
    Ok(())
}

#[test]
fn camber_and_twist_enter_as_nose_up_incidence() -> Outcome {
    let folder = data("tuflex");
    let wing = tuflex()?;
    let mut wing = planform(&wing).clone();
    let of = |wing: &Planform| -> Result<Vec<f64>, nastran::InputError> {
        Ok(wing.bulk(&folder, Mount::Tunnel)?.matrices["W2GJ"].columns[0].clone())
    };
    let cambered = of(&wing)?;
    // Positive camber: the first box is negative, the last positive, and every strip is alike.
    assert!(cambered[0] < 0.0 && cambered[11] > 0.0);
    assert_eq!(cambered[..12], cambered[696..]);
    wing.airfoil = None;
    wing.twist_deg = (2.0, 4.0);
    let twisted = of(&wing)?;
    // Middle of the first strip at 1/112 of the half span; the fairing has the root's twist.
    assert!((twisted[0].to_degrees() - (2.0 + 2.0 / 112.0)).abs() < 1e-12);
    assert!((twisted[707].to_degrees() - 2.0).abs() < 1e-12);
    wing.fairing.as_mut().ok_or("the wing has a fairing")?.camber = false;
    assert_eq!(of(&wing)?[707], 0.0);
    Ok(())
}

/// The camber line z = 4 m x (1 - x) has the slope 4 m (1 - 2x); incidences are taken at 3/4 of every box.
#[test]
fn a_parabolic_camber_line_turns_every_box_by_its_slope_at_three_quarters() -> Outcome {
    let m = 0.02;
    let folder = std::env::temp_dir().join(format!("wingroot_parabola_{}", std::process::id()));
    std::fs::create_dir_all(&folder)?;
    let point = |x: f64, side: f64| {
        format!("{x:.9} {:.9}\n", 4.0 * m * x * (1.0 - x) + side * 0.05 * x.sqrt() * (1.0 - x))
    };
    let places: Vec<f64> = (0..=80).map(|k| (f64::from(k) / 80.0).powi(2)).collect();
    let upper: String = places.iter().rev().map(|x| point(*x, 1.0)).collect();
    let lower: String = places.iter().skip(1).map(|x| point(*x, -1.0)).collect();
    std::fs::copy(data("tuflex/beam_distribution.csv"), folder.join("beam_distribution.csv"))?;
    std::fs::write(folder.join("parabola.dat"), format!("parabola\n{upper}{lower}"))?;
    let mut wing = planform(&tuflex()?).clone();
    wing.airfoil = Some("parabola.dat".into());
    wing.twist_deg = (0.0, 0.0);
    let made = wing.bulk(&folder, Mount::Tunnel);
    std::fs::remove_dir_all(&folder)?;
    let incidence = &made?.matrices["W2GJ"].columns[0];
    for (row, found) in incidence.iter().take(12).enumerate() {
        let x = (row as f64 + 0.75) / 12.0;
        let expected = -4.0 * m * (1.0 - 2.0 * x);
        assert!((found - expected).abs() < 1e-4, "box {row}: {found} beside {expected}");
    }
    Ok(())
}

#[test]
fn strips_may_be_as_unequal_as_the_control_surfaces_need() -> Outcome {
    let mut wing = planform(&tuflex()?).clone();
    wing.controls.truncate(1);
    wing.controls[0].strips = (2, 2);
    (wing.boxes.spanwise, wing.boxes.strip_edges) = (3, Some(vec![0.0, 0.2, 0.7, 1.0]));
    let bulk = wing.bulk(&data("tuflex"), Mount::Aircraft)?;
    assert_eq!(box_counts(&bulk), [36]);
    assert_eq!(bulk.box_lists[&501].boxes, [100_022, 100_023, 100_024]);
    for edges in [vec![0.0, 0.7, 0.2, 1.0], vec![0.0, 0.2, 1.0], vec![0.1, 0.2, 0.7, 1.0]] {
        wing.boxes.strip_edges = Some(edges);
        assert!(wing.bulk(&data("tuflex"), Mount::Aircraft).is_err());
    }
    Ok(())
}

#[test]
fn the_wing_weighs_what_the_paper_says() -> Outcome {
    let system = System::assemble(&Model::from_bulk(&tuflex()?.bulk(Mount::Tunnel)?)?)?;
    let mass_kg = system.mass_properties().mass_kg;
    assert!((mass_kg - 2.2).abs() < 0.001, "{mass_kg} kg");
    Ok(())
}

#[test]
fn clamped_frequencies_are_the_documented_ones() -> Outcome {
    let system = System::assemble(&Model::from_bulk(&tuflex()?.bulk(Mount::Tunnel)?)?)?;
    let modes = normal_modes(&system, 5)?;
    for (omega_rad_s, expected_hz) in modes.omega_rad_s.iter().zip([4.56, 20.4, 30.3, 51.4, 76.2]) {
        let frequency_hz = omega_rad_s / std::f64::consts::TAU;
        assert!(
            (frequency_hz / expected_hz - 1.0).abs() < 0.03,
            "{frequency_hz} Hz, expected {expected_hz} Hz"
        );
    }
    Ok(())
}

#[test]
fn a_kilogram_at_the_tip_bends_the_wing_as_documented() -> Outcome {
    let system = System::assemble(&Model::from_bulk(&tuflex()?.bulk(Mount::Tunnel)?)?)?;
    let tip = system.node_index(FIRST_AXIS_GRID + 36).ok_or("the tip's grid is missing")?;
    let mut force = Mat::zeros(6 * system.node_count(), 1);
    force[(6 * tip + 2, 0)] = 9.80665;
    let free = Flexibility::new(&system)?.displacements(system.reduce(force.as_ref()).as_ref());
    let tip_m = system.expand(free.as_ref())[(6 * tip + 2, 0)];
    assert!((tip_m / 0.0756 - 1.0).abs() < 0.03, "{tip_m} m");
    Ok(())
}

#[test]
fn only_the_tunnel_holds_the_wing_and_monitors_its_root() -> Outcome {
    let wing = tuflex()?;
    let (tunnel, aircraft) = (wing.bulk(Mount::Tunnel)?, wing.bulk(Mount::Aircraft)?);
    assert_eq!(tunnel.constraints.len(), 1);
    assert_eq!(
        (tunnel.monitors[0].name.as_str(), tunnel.monitors[0].xyz),
        ("ROOT", [0.075, 0.0, 0.0].into())
    );
    assert!(aircraft.constraints.is_empty() && aircraft.monitors.is_empty());
    assert_eq!(tunnel.grids, aircraft.grids);
    assert_eq!(wing.spline_grid_ids(&tunnel), (1001..=1037).collect::<Vec<_>>());
    let sensors = planform(&wing).sensor_grids();
    assert_eq!(sensors[3], ("imu_4".to_owned(), 3004));
    assert!((tunnel.grids[&3004].xyz[1] - 1.75).abs() < 1e-12);
    Ok(())
}

#[test]
fn a_misspelt_field_is_found_by_line_and_column() -> Outcome {
    let (from, to) = ("tip_chord_m:", "tip_cord_m:");
    let text = complaint("misspelt", from, to)?;
    // RON points behind the word it has just read.
    let line = place(from, to, to)?.split(':').nth(1).map(str::to_owned).ok_or("no line")?;
    assert!(text.starts_with(&format!(":{line}:")) && text.contains("tip_chord_m"), "{text}");
    Ok(())
}

#[test]
fn numbers_that_cannot_be_are_refused_at_their_place() -> Outcome {
    for (test, from, to, anchor) in [
        ("chord", "tip_chord_m: 0.15", "tip_chord_m: -0.15", "tip_chord_m:"),
        ("strips", "strips: (29, 42)", "strips: (29, 57)", "\"middle\""),
        ("shared", "strips: (29, 42)", "strips: (28, 42)", "\"middle\""),
        ("name", "\"middle\"", "\"inner\"", "\"inner\""),
        ("divides", "chord_strips: 12", "chord_strips: 5", "chord_strips:"),
        ("order", "span_order: 4", "span_order: 40", "span_order:"),
        ("outside", "y_m: 1.545", "y_m: 1.845", "\"servo_outer\""),
        (
            "effects",
            "effects: []",
            "effects: [(name: \"a\", parameters: {\"b\": 1.0}, covariance: [[-1.0]])]",
            "covariance:",
        ),
    ] {
        let text = complaint(test, from, to)?;
        let expected = place(from, to, anchor)?;
        assert!(text.starts_with(&expected), "{test}: expected {expected}, got {text}");
    }
    Ok(())
}

#[test]
fn a_missing_root_plane_is_not_a_free_root() -> Outcome {
    let read = |test: &str, to: &str| -> Result<_, Box<dyn std::error::Error>> {
        let path = edited(test, "root_plane: Symmetric(-0.09),", to)?;
        let wing = WingFile::read(&path)?;
        std::fs::remove_dir_all(wing.folder())?;
        Ok((wing.root_plane, wing.hash))
    };
    let (left_out, hash) = read("plane_left_out", "")?;
    let (free, other_hash) = read("plane_none", "root_plane: None,")?;
    assert_eq!((left_out, free), (None, Some(coupling::wing_file::RootPlane::None)));
    assert_ne!(hash, other_hash);
    assert_eq!(tuflex()?.hash, tuflex()?.hash);
    Ok(())
}

#[test]
fn the_measured_swept_wing_is_read() -> Outcome {
    let wing = WingFile::read(&data("weber_brebner/wing.ron"))?;
    let shape = planform(&wing);
    assert!((2.0 * shape.half_wing_aspect_ratio() - 5.0).abs() < 1e-3);
    let bulk = wing.bulk(Mount::Tunnel)?;
    assert_eq!(box_counts(&bulk), [320]);
    assert!(bulk.grids.is_empty() && wing.spline_grid_ids(&bulk).is_empty());
    Ok(())
}
