//! The shipped wing with a coarse lattice, for laws that need no fine one.

#![expect(clippy::unwrap_used, unreachable_pub, reason = "helpers of the tests in this folder")]
#![allow(dead_code, reason = "not every test file uses every helper")]

pub mod copy;
pub mod flown;

use aero::Corrections;
use coupling::planform::Planform;
use coupling::wing_file::Source;
use coupling::{ElasticWing, Mount, WingFile};
use std::path::Path;

/// The coarse wing, changed.
pub fn wing_with(change: impl Fn(&mut Planform)) -> (WingFile, ElasticWing) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/tuflex/wing_beam.ron");
    let mut file = WingFile::read(&path).unwrap();
    let Source::Parametric(planform) = &mut file.source else { panic!("the shipped wing is parametric") };
    planform.boxes.chordwise = 4;
    planform.boxes.spanwise = 56;
    for control in &mut planform.controls {
        control.chord_boxes = 1;
    }
    change(planform);
    let bulk = file.bulk(Mount::Tunnel).unwrap();
    let wing = ElasticWing::from_bulk(&file, &bulk).unwrap();
    (file, wing)
}

/// Corrections that differ from box to box.
pub fn uneven(wing: &ElasticWing) -> Corrections {
    let boxes = &wing.correctable;
    Corrections {
        force: (0..boxes.len()).map(|b| 1.2 - 0.6 * boxes.y_norm[b]).collect(),
        moment: vec![0.9; boxes.len()],
        pressure_offset: (0..boxes.len()).map(|b| 0.1 * (1.0 - boxes.y_norm[b])).collect(),
    }
}
