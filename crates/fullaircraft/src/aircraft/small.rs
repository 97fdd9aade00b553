//! An aircraft small enough to be assembled within milliseconds: the shipped one with few boxes, elements and modes.

use crate::aircraft::assembly::Aircraft;
use crate::aircraft::file::AircraftFile;
use crate::flight::air::FlightAir;
use coupling::WingFile;
use coupling::planform::Structure;
use coupling::wing_file::{Source, StationAt};
use std::path::{Path, PathBuf};
use std::sync::OnceLock;

/// Folder of the shipped files.
pub(crate) fn data() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/tuflex")
}

/// Its file and its wing's.
pub(crate) fn files() -> (AircraftFile, WingFile) {
    let mut file = AircraftFile::read(&data().join("aircraft.ron")).expect("shipped files are right");
    file.fuselage.half_width_wing_strips = 1;
    file.fuselage.gap_x_m = (0.0, 0.45);
    (file.fuselage.boxes.ahead, file.fuselage.boxes.behind) = (1, 2);
    for tail in [&mut file.htp, &mut file.vtp] {
        (tail.boxes.chordwise, tail.boxes.spanwise, tail.control.chord_boxes) = (2, 1, 1);
    }
    file.modes_up_to_hz = 15.0;
    let mut wing = WingFile::read(&data().join("wing_beam.ron")).expect("shipped files are right");
    wing.stations = vec![StationAt { name: "half".to_owned(), x_m: Some(0.3), y_m: 0.9, z_m: Some(-0.1) }];
    let Source::Parametric(planform) = &mut wing.source else { panic!("it is parametric") };
    (planform.boxes.chordwise, planform.boxes.spanwise) = (2, 6);
    planform.controls.truncate(2);
    for (control, strips) in planform.controls.iter_mut().zip([(2, 3), (4, 6)]) {
        (control.strips, control.chord_boxes) = (strips, 1);
    }
    planform.controls[1].name = "outer".to_owned();
    let Some(Structure::Beam(beam)) = &mut planform.structure else { panic!("it is a beam") };
    beam.elements = 6;
    (file, wing)
}

/// The aircraft.
pub(crate) fn aircraft() -> &'static Aircraft {
    static AIRCRAFT: OnceLock<Aircraft> = OnceLock::new();
    AIRCRAFT.get_or_init(|| {
        let (file, wing) = files();
        Aircraft::new(file, wing).expect("an aircraft")
    })
}

/// Its air.
pub(crate) fn air() -> &'static FlightAir {
    static AIR: OnceLock<FlightAir> = OnceLock::new();
    AIR.get_or_init(|| FlightAir::new(aircraft()).expect("it can be solved"))
}
