//! A beam given by a table over the span: cards worked out by hand, and tables that cannot be.

use crate::planform_laws::trapezoid;
use coupling::planform::{BeamStructure, Mount, Planform, PointMass, Structure};
use nastran::BulkData;
use std::path::PathBuf;

const HEAD: &str = "y_m,EI_flap_Nm2,EI_lag_Nm2,GJ_Nm2,mass_per_span_kg_m,Itheta_kgm,xcg_over_c,xea_over_c\n";
/// Linear from root to tip (4 m).
const ROWS: &str = "0.0,800.0,9000.0,400.0,8.0,0.5,0.4,0.3\n4.0,400.0,1000.0,200.0,4.0,0.3,0.6,0.5\n";

/// A folder of a test's own.
struct Folder(PathBuf);

impl Folder {
    fn with(test: &str, table: &str) -> Self {
        let folder = std::env::temp_dir().join(format!("wingroot-beam-{}-{test}", std::process::id()));
        std::fs::create_dir_all(&folder).expect("a temporary folder");
        std::fs::write(folder.join("beam.csv"), table).expect("a temporary file");
        Self(folder)
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.0);
    }
}

fn mass(name: &str, y_m: f64, x_over_c: f64, mass_kg: f64) -> PointMass {
    PointMass { name: name.to_owned(), y_m, x_over_c, mass_kg }
}

fn wing(elements: usize, point_masses: Vec<PointMass>, sensors: Vec<PointMass>) -> Planform {
    let structure = Structure::Beam(BeamStructure {
        elements,
        distribution: "beam.csv".to_owned(),
        point_masses,
        sensors,
    });
    Planform { structure: Some(structure), ..trapezoid() }
}

fn cards(test: &str, table: &str, wing: &Planform) -> Result<BulkData, nastran::InputError> {
    let folder = Folder::with(test, table);
    wing.bulk(&folder.0, Mount::Tunnel)
}

fn same(found: f64, expected: f64) {
    assert!((found - expected).abs() <= 1e-12 * expected.abs().max(1.0), "{found} beside {expected}");
}

#[test]
fn elements_have_the_stiffness_of_their_middles_and_grids_lie_on_the_axis() {
    let wing = wing(4, Vec::new(), Vec::new());
    let bulk = cards("stiffness", &format!("{HEAD}{ROWS}"), &wing).expect("a wing");
    assert_eq!(bulk.grids.keys().copied().collect::<Vec<_>>(), [1001, 1002, 1003, 1004, 1005]);
    for (at, grid) in (0..5).zip(bulk.grids.values()) {
        let y = f64::from(at);
        assert!((grid.xyz - wing.point(y, 0.3 + 0.05 * y)).norm() < 1e-12, "{:?}", grid.xyz);
    }
    let material = &bulk.materials[&1];
    same(material.nu, material.e / (2.0 * material.g) - 1.0);
    for (at, property) in (0..4_u32).zip(bulk.beam_properties.values()) {
        let y = f64::from(at) + 0.5;
        let (station, chord) = (&property.stations[0], 2.0 - 0.25 * y);
        assert_eq!(property.stations.len(), 2);
        same(station.i1 * material.e, 800.0 - 100.0 * y);
        same(station.i2 * material.e, 9000.0 - 2000.0 * y);
        same(station.j * material.g, 400.0 - 50.0 * y);
        // EA as that of an even strip: 12 EI over the chord squared
        same(station.area * material.e, 12.0 * (9000.0 - 2000.0 * y) / (chord * chord));
        let beam = &bulk.beams[&(2001 + at)];
        assert!(beam.property == 2001 + at && beam.grids == [1001 + at, 1002 + at]);
    }
    assert_eq!(bulk.sets[&1].ids, [1001, 1002, 1003, 1004, 1005]);
    assert_eq!(bulk.sets[&2].ids, [1001]);
    assert_eq!(bulk.constraints[0].grids, [1001]);
    assert_eq!(bulk.constraints[0].components, [1, 2, 3, 4, 5, 6]);
}

#[test]
fn grids_carry_the_mass_half_way_to_their_neighbours_at_its_own_centre() {
    let wing = wing(4, Vec::new(), Vec::new());
    let bulk = cards("mass", &format!("{HEAD}{ROWS}"), &wing).expect("a wing");
    for node in 0..5_u32 {
        let y = f64::from(node);
        let (low, high) = ((y - 0.5).max(0.0), (y + 0.5).min(4.0));
        // mass per span 8 - y, inertia per span 0.5 - 0.05 y
        let of = |power: i32| (high.powi(power) - low.powi(power)) / f64::from(power);
        let kg = 8.0 * of(1) - of(2);
        let centre_y = (8.0 * of(2) - of(3)) / kg;
        let pitch = 0.5 * of(1) - 0.05 * of(2);
        let slab = kg * (high - low) * (high - low) / 12.0;
        let mass = &bulk.masses[&(1001 + node)];
        same(mass.mass, kg);
        assert!(mass.grid == 1001 + node && mass.cid == 0);
        let centre = bulk.grids[&mass.grid].xyz + mass.offset;
        let expected = wing.point(centre_y, 0.4 + 0.05 * centre_y);
        assert!((centre - expected).norm() < 1e-12, "{centre} beside {expected}");
        for (found, expected) in mass.inertia.iter().zip([slab, 0.0, pitch, 0.0, 0.0, pitch + slab]) {
            same(*found, expected);
        }
    }
    let light = ROWS.replace(",8.0,", ",0.0,").replace(",4.0,0.3,", ",0.0,0.3,");
    let bulk = cards("massless", &format!("{HEAD}{light}"), &wing).expect("a wing may be without mass");
    assert!(bulk.masses.is_empty());
}

#[test]
fn masses_hang_on_the_nearest_grid_and_keep_their_place() {
    let masses = vec![mass("servo", 1.4, 0.9, 0.2), mass("tip", 4.0, 2.0, 0.0)];
    let wing = wing(4, masses, vec![mass("imu", 2.6, -1.0, 0.01)]);
    let bulk = cards("points", &format!("{HEAD}{ROWS}"), &wing).expect("a wing");
    for (id, holder, y_m, x_over_c, kg) in
        [(4001, 1002, 1.4, 0.9, 0.2), (4002, 1005, 4.0, 2.0, 0.0), (3001, 1004, 2.6, -1.0, 0.01)]
    {
        assert!((bulk.grids[&id].xyz - wing.point(y_m, x_over_c)).norm() < 1e-12);
        assert!(bulk.rigid[&id].independent == holder && bulk.rigid[&id].dependent == [id], "{id}");
        assert!(bulk.masses[&id].grid == id && (bulk.masses[&id].mass - kg).abs() < 1e-15);
    }
    assert_eq!(wing.sensor_grids(), [("imu".to_owned(), 3001)]);
    let structure = wing.structure.as_ref().expect("a beam");
    assert_eq!((structure.point_masses().len(), structure.sensors().len()), (2, 1));
}

#[test]
fn masses_and_counts_that_cannot_be_are_refused() {
    let said = |wing: Planform| {
        cards("refused", &format!("{HEAD}{ROWS}"), &wing)
            .err()
            .map(|error| error.to_string())
            .unwrap_or_default()
    };
    let one = |item: PointMass| said(wing(1, vec![item], Vec::new()));
    assert_eq!(one(mass("a", 0.0, -1.0, 0.0)), "");
    for bad in [
        mass("a", -0.1, 0.0, 1.0),
        mass("a", 4.1, 0.0, 1.0),
        mass("a", 1.0, -1.1, 1.0),
        mass("a", 1.0, 2.1, 1.0),
        mass("a", 1.0, 0.0, -0.1),
        mass("a", 1.0, 0.0, f64::INFINITY),
    ] {
        assert!(one(bad.clone()).contains("one of which cannot be"), "{bad:?}");
    }
    assert!(one(mass("", 1.0, 0.0, 1.0)).contains("two masses are called"));
    let twice = wing(1, vec![mass("a", 1.0, 0.0, 1.0)], vec![mass("a", 2.0, 0.0, 1.0)]);
    assert!(said(twice).contains("two masses are called \"a\""));
    assert_eq!(said(wing(1900, Vec::new(), Vec::new())), "");
    assert!(said(wing(0, Vec::new(), Vec::new())).contains("elements is 0"));
    assert!(said(wing(1901, Vec::new(), Vec::new())).contains("elements is 1901"));
}

#[test]
fn tables_must_ascend_from_root_to_tip_with_stiffness_everywhere() {
    let wing = wing(2, Vec::new(), Vec::new());
    let said = |rows: &str| {
        cards("table", &format!("{HEAD}{rows}"), &wing)
            .err()
            .map(|error| error.to_string())
            .unwrap_or_default()
    };
    assert_eq!(said(ROWS), "");
    assert_eq!(said(&ROWS.replace("0.0,800", "-1.0,800").replace("4.0,400.0,1", "4.5,400.0,1")), "");
    // inertia and mass may vanish, but not be less
    assert_eq!(said(&ROWS.replace("8.0,0.5", "0.0,0.0")), "");
    assert!(said(&ROWS.replace("8.0,0.5", "-8.0,0.5")).contains("mass_per_span_kg_m is -8"));
    assert!(said(&ROWS.replace("8.0,0.5", "8.0,-0.5")).contains("Itheta_kgm is -0.5"));
    for (from, to, column) in [
        ("800.0", "0.0", "EI_flap_Nm2 is 0"),
        ("9000.0", "0.0", "EI_lag_Nm2 is 0"),
        ("200.0,4", "0.0,4", "GJ_Nm2 is 0"),
        ("200.0,4", "-2.0,4", "GJ_Nm2 is -2"),
    ] {
        let error = said(&ROWS.replace(from, to));
        assert!(error.contains(column) && error.contains("above zero"), "{column}: {error}");
    }
    // centres may be ahead of the leading edge
    assert_eq!(said(&ROWS.replace(",0.4,0.3", ",-0.4,-0.3")), "");
    let again = format!("{ROWS}4.0,400.0,1000.0,200.0,4.0,0.3,0.6,0.5\n");
    assert!(said(&again).contains("y_m is 4 after 4"), "{}", said(&again));
    assert!(said(&ROWS.replace("0.0,800", "0.1,800")).contains("covers y = 0.1 to 4 m"));
    assert!(
        said(&ROWS.replace("4.0,400.0,1", "3.9,400.0,1")).contains("to 3.9 m, expected 0 to the half span 4")
    );
    let unknown = cards("unknown", &format!("{HEAD}{ROWS}").replace("GJ_Nm2", "GJ"), &wing);
    assert!(unknown.is_err_and(|error| error.to_string().contains("GJ")));
}
