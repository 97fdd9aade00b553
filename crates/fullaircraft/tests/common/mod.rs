//! The shipped aircraft on beam wings, assembled once for a test file: the wing the table of data/tuflex/README.md was made
//! with, and small enough to be tried in many ways.
#![expect(unreachable_pub, reason = "a module of several test programs")]
#![allow(dead_code, reason = "each test file uses its own part")]

use fullaircraft::{Aircraft, AircraftFile, FlightAir, Surfaces};
use std::path::{Path, PathBuf};
use std::sync::OnceLock;

/// The shipped file.
pub fn path() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/tuflex/aircraft.ron")
}

/// The beam wing.
pub fn beam_wing() -> PathBuf {
    path().with_file_name("wing_beam.ron")
}

/// Tail and fuselage in the flow.
pub fn whole() -> &'static Aircraft {
    static WHOLE: OnceLock<Aircraft> = OnceLock::new();
    WHOLE.get_or_init(|| Aircraft::read(&path(), Some(&beam_wing())).expect("shipped files are right"))
}

/// Unsteady air of [`whole`].
pub fn air() -> &'static FlightAir {
    static AIR: OnceLock<FlightAir> = OnceLock::new();
    AIR.get_or_init(|| FlightAir::new(whole()).expect("the shipped lattice is right"))
}

/// Wings alone.
pub fn wings() -> &'static Aircraft {
    static WINGS: OnceLock<Aircraft> = OnceLock::new();
    WINGS.get_or_init(|| {
        let file = AircraftFile {
            surfaces: Surfaces::WingsOnly,
            ..AircraftFile::read(&path()).expect("shipped files are right")
        };
        let wing = coupling::WingFile::read(&beam_wing()).expect("shipped files are right");
        Aircraft::new(file, wing).expect("shipped files are right")
    })
}

/// Asserts that a value is within a share of another.
pub fn assert_near(what: &str, value: f64, expected: f64, share: f64) {
    let off = (value - expected).abs() / expected.abs();
    assert!(off <= share, "{what}: {value} is {:.1} % off {expected}", 100.0 * off);
}
