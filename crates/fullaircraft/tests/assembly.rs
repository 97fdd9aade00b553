//! What the aircraft is made of: boxes, masses, the mirror image, natural modes.

use crate::common::{assert_near, path, whole, wings};
use aero::{Corrections, Lattice};
use coupling::WingFile;
use coupling::planform::Mount;
use fullaircraft::model::mirror::Image;
use fullaircraft::{Aircraft, AircraftFile, FreeModes};
use loads::design::MassCase;
use std::collections::BTreeSet;

#[test]
fn the_boxes_are_as_many_as_published() {
    // Published: 1344 on the wings, 135 on the vertical tail, 192 on the horizontal tail, 160 on the fuselage.
    let count = |from: u32, to: u32| {
        let surfaces = whole().flow.lattice.surfaces.iter().filter(|s| (from..to).contains(&s.id));
        surfaces.map(|s| s.chordwise * s.spanwise).sum::<usize>()
    };
    let million = 1_000_000;
    assert_eq!(count(0, 2 * million), 1344);
    assert_eq!(count(2 * million, 4 * million), 192);
    assert_eq!(count(4 * million, 5 * million), 135);
    assert_eq!(count(5 * million, u32::MAX), 160);
    assert_eq!(whole().flow.lattice.len(), 1831);
    assert_eq!(wings().flow.lattice.len(), 1344);
}

#[test]
fn mass_centre_and_inertia_are_those_of_the_file() {
    let mass = &whole().mass;
    assert_near("mass", mass.mass_kg, 20.0, 1e-12);
    assert!(
        (mass.centre.x - 0.40).abs() < 1e-12 && mass.centre.y.abs() < 1e-12 && mass.centre.z.abs() < 1e-12
    );
    for (axis, expected) in [1.94, 2.6, 4.4].into_iter().enumerate() {
        assert_near("inertia", mass.inertia_kg_m2[(axis, axis)], expected, 1e-10);
    }
    // Symmetry: no products of inertia with y.
    assert!(mass.inertia_kg_m2[(0, 1)].abs() < 1e-12 && mass.inertia_kg_m2[(1, 2)].abs() < 1e-12);
}

#[test]
fn a_state_of_loading_has_its_totals_and_is_the_aircraft_that_is_built_with_them() {
    let state = MassCase {
        name: "light".to_owned(),
        mass_kg: 15.0,
        x_cg_m: Some(0.43),
        z_cg_m: None,
        ixx_kg_m2: Some(1.9),
        iyy_kg_m2: Some(2.2),
        izz_kg_m2: Some(4.0),
        ixz_kg_m2: None,
    };
    let loaded = whole().loaded(&state).unwrap();
    let mass = &loaded.mass;
    assert_near("mass", mass.mass_kg, 15.0, 1e-12);
    assert_near("centre of gravity", mass.centre.x, 0.43, 1e-12);
    for (axis, expected) in [1.9, 2.2, 4.0].into_iter().enumerate() {
        assert_near("inertia", mass.inertia_kg_m2[(axis, axis)], expected, 1e-10);
    }
    let mut file = whole().file.clone();
    (file.total.mass_kg, file.total.x_cg_m) = (15.0, 0.43);
    (file.total.ixx_kg_m2, file.total.iyy_kg_m2, file.total.izz_kg_m2) = (1.9, 2.2, 4.0);
    let built = Aircraft::new(file, whole().wing.clone()).unwrap();
    let near = |what: &str, a: &[f64], b: &[f64]| {
        assert_eq!(a.len(), b.len(), "{what}");
        let largest = b.iter().fold(0.0_f64, |most, value| most.max(value.abs()));
        let off = a.iter().zip(b).fold(0.0_f64, |most, (a, b)| most.max((a - b).abs()));
        assert!(off < 1e-12 * largest, "{what} is {off} off {largest}");
    };
    let dense = |matrix: &faer::Mat<f64>| -> Vec<f64> {
        (0..matrix.ncols()).flat_map(|j| matrix.col(j).iter().copied()).collect()
    };
    near("mass of the free motions", loaded.free.mass().val(), built.free.mass().val());
    near("inertia of rigid accelerations", &dense(&loaded.inertia.mass), &dense(&built.inertia.mass));
    near("what they bend", &dense(&loaded.inertia.sag), &dense(&built.inertia.sag));
    near("rows of the resultants", &dense(&loaded.flow.root_rows), &dense(&built.flow.root_rows));
    let weight =
        |aircraft: &Aircraft| dense(&aircraft.flow.supported.as_ref().expect("it is elastic").weight);
    near("weight", &weight(&loaded), &weight(&built));
    assert_eq!(loaded.bulk.masses.len(), built.bulk.masses.len());
}

#[test]
fn a_wing_mirrored_twice_is_itself() {
    let wing = WingFile::read(&AircraftFile::read(&path()).unwrap().wing_path()).unwrap();
    let bulk = wing.bulk(Mount::Aircraft).unwrap();
    let image = Image::of(&bulk).unwrap();
    let again = Image::of(&image.bulk).unwrap();
    assert_eq!(again.bulk, bulk);
    assert!(image.boxes.iter().all(|(from, to)| again.boxes[to] == *from));
    let lattice = Lattice::from_bulk(&bulk).unwrap();
    let mirrored = Lattice::from_bulk(&image.bulk).unwrap();
    let places = image.check(&lattice, &mirrored, 0).unwrap();
    assert_eq!(places.iter().collect::<BTreeSet<_>>().len(), 672, "one to one");
    assert!(places.iter().enumerate().all(|(from, to)| from != *to), "56 strips: none is its own image");
}

#[test]
fn corrections_go_to_the_mirrored_box_and_stay_neutral_elsewhere() {
    let aircraft = whole();
    let numbered = |shift: f64| (0..672).map(|i| f64::from(i) + shift).collect::<Vec<f64>>();
    let wing = Corrections { force: numbered(0.25), moment: numbered(0.5), pressure_offset: numbered(0.75) };
    let all = aircraft.corrections(&wing).unwrap();
    let boxes = &aircraft.flow.lattice.boxes;
    for i in 0..672 {
        let right = aircraft.right.boxes[i];
        let there = boxes[right].mid_point();
        let left = (0..1344)
            .find(|j| {
                let here = boxes[*j].mid_point();
                (here.x - there.x).abs() + (here.y + there.y).abs() + (here.z - there.z).abs() < 1e-9
            })
            .unwrap();
        for at in [right, left] {
            assert_eq!((all.force[at], all.moment[at]), (wing.force[i], wing.moment[i]));
            assert_eq!(all.pressure_offset[at], wing.pressure_offset[i]);
        }
    }
    for at in 1344..1831 {
        assert_eq!((all.force[at], all.moment[at], all.pressure_offset[at]), (1.0, 1.0, 0.0));
    }
    assert!(aircraft.corrections(&Corrections::neutral(671)).is_err());
}

#[test]
fn the_free_aircraft_has_six_rigid_motions_and_the_expected_bending_modes() {
    // 4.74 Hz, and 12.1 to 10.8 Hz for 0.1 to 0.2 kg m2 of fuselage roll inertia: independent program, as in trim.rs.
    let aircraft = whole();
    let modes = FreeModes::new(aircraft).unwrap();
    let hz = modes.frequencies_hz();
    assert!(hz[..6].iter().all(|f| *f == 0.0), "{hz:?}");
    assert_near("first symmetric bending", hz[6], 4.74, 0.02);
    assert!((10.8..=12.1).contains(&hz[7]), "first antisymmetric bending at {} Hz", hz[7]);
    let tips =
        |mode: usize| [&aircraft.right, &aircraft.left].map(|wing| modes.shapes[(6 * wing.tip + 2, mode)]);
    let ([right, left], [up, down]) = (tips(6), tips(7));
    assert_near("symmetric tips", left, right, 1e-6);
    assert_near("antisymmetric tips", down, -up, 1e-6);
}

#[test]
fn totals_that_no_body_can_complete_are_refused() {
    let file = AircraftFile::read(&path()).unwrap();
    let wing = WingFile::read(&file.wing_path()).unwrap();
    let mut light = file.clone();
    light.total.mass_kg = 5.0;
    let error = Aircraft::new(light, wing.clone()).unwrap_err().to_string();
    assert!(error.contains("total.mass_kg is 5"), "{error}");
    let mut slim = file.clone();
    slim.total.ixx_kg_m2 = 1.0;
    let error = Aircraft::new(slim, wing.clone()).unwrap_err().to_string();
    assert!(error.contains("which no body has"), "{error}");
    let mut narrow = file;
    narrow.fuselage.gap_x_m = (0.0, 0.30);
    let error = Aircraft::new(narrow, wing).unwrap_err().to_string();
    assert!(error.contains("gap_x_m"), "{error}");
}
