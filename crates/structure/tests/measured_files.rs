//! Files of measurements: what they say as degrees of freedom of a structure, the regions they name, and what is
//! refused.

use nastran::{BulkData, parse_deck};
use std::path::PathBuf;
use structure::update::file::{
    DeflectionEntry, MassEntry, MeasuredFile, ModeEntry, MotionEntry, RegionEntry,
};
use structure::update::{Parameter, Quantity};
use structure::{Model, System};

/// One element of every kind that has a property, and others; places of their middles along x are 0.5, 1.5, ...
const DECK: &str = "GRID,1,,0.,0.,0.\nGRID,2,,1.,0.,0.\nGRID,3,,2.,0.,0.\nGRID,4,,3.,0.,0.\nGRID,5,,4.,0.,0.\n\
    GRID,6,,0.,1.,0.\n\
    GRID,7,,1.,1.,0.\nGRID,8,,0.,1.,2.\nGRID,9,,2.,2.,4.\n\
    CBAR,1,21,1,2,0.,0.,1.\nCROD,2,22,2,3\nCTUBE,3,23,3,4\nCONROD,4,4,5,1,.01\nCBUSH,5,25,4,9,,,,0\n\
        CQUAD4,6,26,1,2,7,6\n\
    CTETRA,7,27,1,2,7,8\nCSHEAR,8,28,1,2,7,6\nCONM2,9,9,,2.\nCELAS2,10,5.,9,1\nCBEAM,11,31,1,8,1.,0.,0.\n\
        CTRIA3,12,32,2,7,8\n\
    PBAR,21,1,1.-4,4.-9,1.-9,2.-9\nPROD,22,1,.01\nPTUBE,23,1,.05\nPBUSH,25,K,4.+5,3.+5,2.+5,1.+4,2.+4,3.+4\n\
        PSHELL,26,1,.05,1\n\
    PSOLID,27,1\nPSHEAR,28,1,.01\nPBEAM,31,1,1.-4,4.-9,1.-9,,2.-9\nPCOMP,32\n,1,.02,0.\nMAT1,1,7.+10,,.3,2700.\n\
        SPC1,1,123456,1\n";

fn deck() -> (BulkData, Model) {
    let bulk = parse_deck("test.bdf", DECK).expect("a deck");
    let model = Model::from_bulk(&bulk).expect("a model");
    (bulk, model)
}

fn system() -> System {
    System::assemble(&deck().1).expect("a structure")
}

fn mode(frequency_hz: f64, sigma_hz: f64) -> ModeEntry {
    ModeEntry { name: None, frequency_hz, sigma_hz, shape: Vec::new(), mode: None }
}

fn motion(grid: u32, component: u8, value: f64) -> MotionEntry {
    MotionEntry { grid, component, value }
}

fn deflection(loads: Vec<MotionEntry>, grid: u32, component: u8, sigma: f64) -> DeflectionEntry {
    DeflectionEntry { name: "tip".into(), loads, grid, component, value: -0.25, sigma }
}

#[test]
fn grids_and_components_become_degrees_of_freedom() {
    let shape = vec![motion(2, 1, 0.5), motion(9, 6, -2.0), motion(1, 3, 7.0)];
    let file = MeasuredFile {
        modes: vec![
            mode(3.0, 0.1),
            ModeEntry { name: Some("first".into()), shape, ..mode(5.0, 0.2) },
            ModeEntry { mode: Some(7), ..mode(8.0, 0.3) },
            mode(9.0, 0.4),
        ],
        deflections: vec![deflection(vec![motion(3, 2, 40.0), motion(4, 4, -1.5)], 5, 5, 1e-3)],
        mass: Some(MassEntry { kg: 12.0, sigma_kg: 0.25 }),
        ..MeasuredFile::default()
    };
    let found = file.measurements(&system()).expect("sound");
    let names: Vec<&str> = found.modes.iter().map(|mode| mode.name.as_str()).collect();
    assert_eq!(names, ["mode 1", "first", "mode 3", "mode 4"]);
    let numbers: Vec<(f64, f64)> =
        found.modes.iter().map(|mode| (mode.frequency_hz, mode.sigma_hz)).collect();
    assert_eq!(numbers, [(3.0, 0.1), (5.0, 0.2), (8.0, 0.3), (9.0, 0.4)]);
    // Without a shape a mode is the model's of its place or of the number given, from one on; with one it is to be
    // found.
    let modes: Vec<Option<usize>> = found.modes.iter().map(|mode| mode.mode).collect();
    assert_eq!(modes, [Some(0), None, Some(6), Some(3)]);
    assert_eq!(found.modes[1].shape, [(6, 0.5), (6 * 8 + 5, -2.0), (2, 7.0)]);
    let tip = &found.deflections[0];
    assert_eq!(tip.loads, [(6 * 2 + 1, 40.0), (6 * 3 + 3, -1.5)]);
    assert_eq!((tip.name.as_str(), tip.motion, tip.value, tip.sigma), ("tip", 6 * 4 + 4, -0.25, 1e-3));
    assert_eq!(found.mass_kg, Some((12.0, 0.25)));
    let nothing = MeasuredFile::default().measurements(&system()).expect("sound");
    assert!(nothing.modes.is_empty() && nothing.deflections.is_empty() && nothing.mass_kg.is_none());
}

#[test]
fn what_cannot_be_measured_is_refused_by_what_is_wrong() {
    let system = system();
    let of_modes = |modes: Vec<ModeEntry>| MeasuredFile { modes, ..MeasuredFile::default() };
    let of_tip =
        |entry: DeflectionEntry| MeasuredFile { deflections: vec![entry], ..MeasuredFile::default() };
    let of_mass = |kg: f64, sigma_kg: f64| MeasuredFile {
        mass: Some(MassEntry { kg, sigma_kg }),
        ..MeasuredFile::default()
    };
    let shaped = |at: MotionEntry| of_modes(vec![ModeEntry { shape: vec![at], ..mode(1.0, 0.1) }]);
    let numbered = |number: usize| of_modes(vec![ModeEntry { mode: Some(number), ..mode(1.0, 0.1) }]);
    let free = system.free_count();
    assert!(free < 200 && numbered(free).measurements(&system).is_ok());
    let beyond = format!("mode 1 is the model's mode {}, and the model has {free} free motions", free + 1);
    for (file, said) in [
        (shaped(motion(1, 0, 1.0)), "shape: component 0 is none of 1 to 6"),
        (shaped(motion(1, 7, 1.0)), "shape: component 7 is none of 1 to 6"),
        (shaped(motion(77, 1, 1.0)), "shape: GRID 77 is not in the model"),
        (of_tip(deflection(vec![motion(1, 0, 1.0)], 1, 1, 0.1)), "loads: component 0 is none of 1 to 6"),
        (of_tip(deflection(Vec::new(), 1, 7, 0.1)), "deflections: component 7 is none of 1 to 6"),
        (of_tip(deflection(Vec::new(), 77, 1, 0.1)), "deflections: GRID 77 is not in the model"),
        (
            of_tip(deflection(Vec::new(), 1, 1, 0.0)),
            "the standard deviation of tip is 0, not a positive number",
        ),
        (of_modes(vec![mode(0.0, 0.1)]), "the frequency of mode 1 is 0, not a positive number"),
        (of_modes(vec![mode(f64::INFINITY, 0.1)]), "the frequency of mode 1 is inf, not a positive number"),
        (of_modes(vec![mode(1.0, 0.1), mode(1.0, -0.1)]), "the standard deviation of mode 2 is -0.1"),
        (of_modes(vec![mode(1.0, f64::NAN)]), "the standard deviation of mode 1 is NaN"),
        (of_mass(0.0, 0.1), "the mass is 0, not a positive number"),
        (of_mass(1.0, 0.0), "the standard deviation of the mass is 0"),
        (numbered(0), "mode 1: modes are numbered from 1"),
        (numbered(free + 1), beyond.as_str()),
    ] {
        let error = file.measurements(&system).expect_err(said).to_string();
        assert!(error.contains(said), "{error}");
    }
    for component in 1..=6 {
        assert!(shaped(motion(9, component, 1.0)).measurements(&system).is_ok());
    }
}

#[test]
fn two_of_one_name_are_refused_but_in_another_list() {
    let system = system();
    let named = |name: &str| ModeEntry { name: Some(name.into()), ..mode(1.0, 0.1) };
    let tip = || deflection(Vec::new(), 1, 1, 0.1);
    let file = |modes: Vec<ModeEntry>, deflections: Vec<DeflectionEntry>, regions: Vec<RegionEntry>| {
        MeasuredFile { modes, deflections, regions, ..MeasuredFile::default() }
    };
    let apart = file(
        vec![named("tip"), named("b"), mode(1.0, 0.1), mode(1.0, 0.1)],
        vec![tip()],
        vec![region("tip")],
    );
    assert!(apart.measurements(&system).is_ok());
    for (twins, said) in [
        (file(vec![named("a"), named("a")], Vec::new(), Vec::new()), "two of the modes are called \"a\""),
        (file(Vec::new(), vec![tip(), tip()], Vec::new()), "two of the deflections are called \"tip\""),
        (file(Vec::new(), Vec::new(), vec![region("a"), region("a")]), "two of the regions are called \"a\""),
    ] {
        let error = twins.measurements(&system).expect_err(said).to_string();
        assert!(error.contains(said), "{error}");
    }
}

fn region(name: &str) -> RegionEntry {
    RegionEntry {
        name: name.into(),
        elements: None,
        properties: None,
        x_m: None,
        y_m: None,
        z_m: None,
        fit: vec![Quantity::Stiffness],
    }
}

fn parameters(regions: Vec<RegionEntry>) -> Result<Vec<Parameter>, String> {
    let (bulk, model) = deck();
    let file = MeasuredFile { regions, ..MeasuredFile::default() };
    file.parameters(&bulk, &model).map_err(|error| error.to_string())
}

/// Numbers of the elements in a region.
fn chosen(entry: RegionEntry) -> Vec<u32> {
    let found = parameters(vec![entry]).expect("a region");
    assert_eq!((found.len(), found[0].region.as_str()), (1, "a"));
    let model = deck().1;
    let mut ids: Vec<u32> = found[0].elements.iter().map(|place| model.elements[*place].id()).collect();
    ids.sort_unstable();
    ids
}

#[test]
fn properties_choose_elements_of_every_kind() {
    for (property, id) in [(21, 1), (22, 2), (23, 3), (25, 5), (26, 6), (27, 7), (28, 8), (31, 11), (32, 12)]
    {
        let entry = RegionEntry { properties: Some([property].into()), ..region("a") };
        assert_eq!(chosen(entry), [id], "property {property}");
    }
    let entry = RegionEntry { properties: Some([21, 28, 32].into()), ..region("a") };
    assert_eq!(chosen(entry), [1, 8, 12]);
}

#[test]
fn regions_are_what_passes_all_of_their_conditions() {
    let (low, high) = (f64::NEG_INFINITY, f64::INFINITY);
    assert_eq!(chosen(region("a")), (1..=12).collect::<Vec<u32>>(), "without a condition all");
    assert_eq!(chosen(RegionEntry { elements: Some([3, 9, 77].into()), ..region("a") }), [3, 9]);
    // Middles along x: 0.5, 1.5, 2.5, 3.5 of the line, 2.5 of the bush, 2 of grid 9; the first end counts, the second
    // not.
    let along = |a: f64, b: f64| chosen(RegionEntry { x_m: Some((a, b)), ..region("a") });
    assert_eq!(along(1.5, 2.5), [2, 9, 10]);
    assert_eq!(along(2.5, 3.5), [3, 5]);
    assert_eq!(along(2.6, high), [4]);
    let up = |a: f64, b: f64| chosen(RegionEntry { z_m: Some((a, b)), ..region("a") });
    // A third of grid 8's height for the triangle, half of it for the beam and the tetrahedron's quarter; the bush
    // between 0 and 4.
    assert_eq!(up(0.5, 0.6), [7]);
    assert_eq!(up(0.6, 0.9), [12]);
    assert_eq!(up(1.0, 3.0), [5, 11]);
    assert_eq!(up(4.0, high), [9, 10]);
    let across = |a: f64, b: f64| chosen(RegionEntry { y_m: Some((a, b)), ..region("a") });
    assert_eq!(across(low, 0.1), [1, 2, 3, 4]);
    assert_eq!(across(0.6, 0.7), [12]);
    let both =
        RegionEntry { x_m: Some((0.0, 1.0)), y_m: Some((0.4, 0.6)), z_m: Some((low, 0.3)), ..region("a") };
    assert_eq!(chosen(both), [6, 8]);
}

#[test]
fn regions_share_elements_of_different_quantities_alone() {
    let of = |name: &str, fit: &[Quantity], ids: &[u32]| RegionEntry {
        elements: Some(ids.iter().copied().collect()),
        fit: fit.to_vec(),
        ..region(name)
    };
    let (stiffness, mass) = (Quantity::Stiffness, Quantity::Mass);
    let found =
        parameters(vec![of("a", &[stiffness, mass], &[1, 2]), of("b", &[stiffness], &[3])]).expect("apart");
    let own: Vec<(&str, Quantity, usize)> =
        found.iter().map(|p| (p.region.as_str(), p.quantity, p.elements.len())).collect();
    assert_eq!(own, [("a", stiffness, 2), ("a", mass, 2), ("b", stiffness, 1)]);
    assert!(parameters(vec![of("a", &[stiffness], &[1, 2]), of("b", &[mass], &[2])]).is_ok());
    for (regions, said) in [
        (
            vec![of("a", &[stiffness], &[1, 2]), of("b", &[stiffness], &[2, 3])],
            "element 2 is in the regions \"a\" and \"b\"",
        ),
        (vec![of("a", &[stiffness], &[77])], "no element of the model is in the region \"a\""),
        (vec![of("a", &[], &[1])], "nothing of the region \"a\" is fitted"),
    ] {
        let error = parameters(regions).expect_err(said);
        assert!(error.contains(said), "{error}");
    }
}

/// A file in a folder of this process; taken away when it is dropped.
struct Written(PathBuf);

impl Written {
    fn new(name: &str, text: &str) -> Self {
        let path = std::env::temp_dir().join(format!("wingroot_structure_{}_{name}", std::process::id()));
        std::fs::write(&path, text).expect("a folder for temporary files");
        Self(path)
    }

    fn read(&self) -> Result<MeasuredFile, String> {
        MeasuredFile::read(&self.0).map_err(|error| error.to_string())
    }
}

impl Drop for Written {
    fn drop(&mut self) {
        let _ = std::fs::remove_file(&self.0);
    }
}

#[test]
fn files_are_read_as_lists_or_as_a_table_of_frequencies() {
    let table = Written::new("modes.CSV", "frequency_hz,sigma_hz\n3.5,0.1\n7.25,0.2\n");
    let found = table.read().expect("a table");
    assert_eq!(found.modes, [mode(3.5, 0.1), mode(7.25, 0.2)]);
    assert_eq!(found.path, table.0);
    let list = Written::new(
        "all.ron",
        "(mass: (kg: 12.0, sigma_kg: 0.25), regions: [(name: \"a\", x_m: (0.0, 1.0), fit: [Mass])])",
    );
    let found = list.read().expect("a list");
    assert_eq!(found.mass, Some(MassEntry { kg: 12.0, sigma_kg: 0.25 }));
    assert_eq!(
        found.regions,
        [RegionEntry { x_m: Some((0.0, 1.0)), fit: vec![Quantity::Mass], ..region("a") }]
    );
    let tip = Written::new(
        "tip.ron",
        "(deflections: [(name: \"tip\", loads: [(grid: 3, component: 2, value: 40.0)], grid: 5, component: 5, \
         value: -0.25, sigma: 0.001)])",
    );
    assert_eq!(tip.read().expect("a list").deflections, [deflection(vec![motion(3, 2, 40.0)], 5, 5, 1e-3)]);
    let only = Written::new("only.ron", "(modes: [(frequency_hz: 3.5, sigma_hz: 0.1)])");
    assert_eq!(only.read().expect("a list").modes, [mode(3.5, 0.1)]);
    let empty = Written::new("empty.ron", "(regions: [(name: \"a\", fit: [Mass])])");
    let error = empty.read().expect_err("nothing");
    assert!(error.contains("nothing is measured here"), "{error}");
    assert!(Written::new("one.csv", "frequency_hz\n3.5\n").read().is_err());
}
