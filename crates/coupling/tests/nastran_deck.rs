//! The deck of the shipped wing, read again, is the same structure with the same boxes.

#![expect(clippy::unwrap_used, reason = "a helper of tests may fail the test where it stands")]

use aero::{Corrections, Lattice};
use coupling::{DeckOptions, Mount, NastranDeck, WingFile};
use nastran::{BulkData, parse_deck};
use std::path::Path;
use structure::{Model, System, normal_modes};

fn shipped(file: &str) -> WingFile {
    WingFile::read(&Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../../data/tuflex")).join(file)).unwrap()
}

fn wing() -> WingFile {
    shipped("wing.ron")
}

/// Mass, and the first ten frequencies in rad/s.
fn mass_and_frequencies(bulk: &BulkData) -> (f64, Vec<f64>) {
    let system = System::assemble(&Model::from_bulk(bulk).unwrap()).unwrap();
    (system.mass_properties().mass_kg, normal_modes(&system, 10).unwrap().omega_rad_s)
}

fn same(a: f64, b: f64, relative: f64, what: &str) {
    assert!((a - b).abs() <= relative * b.abs(), "{what}: {a} and {b}");
}

/// Fields of a deck hold eleven digits; the beam wing's beams are uniform, so bars say the same.
#[test]
fn the_written_deck_is_the_same_wing() {
    is_the_same_wing(&wing(), &[false]);
    is_the_same_wing(&shipped("wing_beam.ron"), &[false, true]);
}

fn is_the_same_wing(file: &WingFile, with_bars: &[bool]) {
    let original = file.bulk(Mount::Tunnel).unwrap();
    let (mass, frequencies) = mass_and_frequencies(&original);
    for bars in with_bars.iter().copied() {
        let options = DeckOptions { modes: 10, bars, corrections: None };
        let deck = NastranDeck::of(file, &options).unwrap();
        assert_eq!(deck.kept_beams, 0);
        let read = parse_deck("wing.bdf", &deck.text).unwrap();
        let count = |name: &str| read.element_counts().get(name).copied().unwrap_or(0);
        assert_eq!(count("CBAR") > 0, bars);
        assert_eq!(count("CBEAM") > 0, !bars && original.element_counts().contains_key("CBEAM"));
        let (mass_read, frequencies_read) = mass_and_frequencies(&read);
        same(mass_read, mass, 1e-9, "mass");
        for (got, want) in frequencies_read.iter().zip(&frequencies) {
            same(*got, *want, 1e-8, "frequency");
        }
        let (boxes, wanted) = (Lattice::from_bulk(&read).unwrap(), Lattice::from_bulk(&original).unwrap());
        assert_eq!(boxes.len(), wanted.len());
        for (got, want) in boxes.boxes.iter().zip(&wanted.boxes) {
            assert_eq!(got.id, want.id);
            assert!(got.corners.iter().zip(&want.corners).all(|(a, b)| (a - b).norm() < 1e-9));
        }
        assert_eq!(read.monitors.len(), 1);
        assert_eq!(read.surfaces.len(), original.surfaces.len());
        let camber = |bulk: &BulkData| bulk.matrices["W2GJ"].columns[0].clone();
        assert!(camber(&read).iter().zip(camber(&original)).all(|(a, b)| (a - b).abs() < 1e-4));
    }
}

#[test]
fn every_box_is_in_one_spline_and_the_control_reads_the_sets_that_are_there() {
    let deck = NastranDeck::of(&wing(), &DeckOptions { modes: 7, ..DeckOptions::default() }).unwrap();
    let read = parse_deck("wing.bdf", &deck.text).unwrap();
    let lattice = Lattice::from_bulk(&read).unwrap();
    for panel in &lattice.boxes {
        let inside = |first: u32, last: u32| (first..=last).contains(&panel.id);
        assert_eq!(
            read.splines.values().filter(|s| inside(s.boxes.0, s.boxes.1)).count(),
            1,
            "box {}",
            panel.id
        );
    }
    assert!(read.splines.values().all(|spline| read.sets.contains_key(&spline.set)));
    let (control, bulk) = deck.text.split_once("BEGIN BULK").unwrap();
    assert!(control.contains("SOL 103\nCEND\n") && control.contains("\nMETHOD = 1\n"));
    assert!(control.contains(&format!("\nSPC = {}\n", read.constraints[0].set)));
    assert!(bulk.contains("\nEIGRL,1,,,7\n"));
    // The wall at y = -0.09 m is the plane of symmetry; half span 1.8 m and 0.405 m2 as published.
    assert!(bulk.contains(",0.22500,3.60000,0.40500,1\n"), "AEROS");
    assert!(bulk.trim_end().ends_with("ENDDATA"));
}

#[test]
fn no_number_is_used_for_two_elements() {
    let deck = NastranDeck::of(&wing(), &DeckOptions::default()).unwrap().bulk;
    let mut numbers: Vec<u32> =
        deck.beams.keys().chain(deck.shells.keys()).chain(deck.solids.keys()).copied().collect();
    numbers.extend(
        deck.masses.keys().chain(deck.rigid.keys()).chain(deck.averages.keys()).chain(deck.bushes.keys()),
    );
    let count = numbers.len();
    numbers.sort_unstable();
    numbers.dedup();
    assert_eq!(numbers.len(), count);
}

#[test]
fn corrections_are_written_for_every_box_and_come_back() {
    let file = wing();
    let boxes = Lattice::from_bulk(&file.bulk(Mount::Tunnel).unwrap()).unwrap().len();
    let mut corrections = Corrections::neutral(boxes);
    corrections.force[3] = 1.25;
    corrections.pressure_offset[5] = -0.125;
    let options = DeckOptions { modes: 1, bars: false, corrections: Some(corrections.clone()) };
    let read = parse_deck("wing.bdf", &NastranDeck::of(&file, &options).unwrap().text).unwrap();
    assert_eq!(Corrections::from_dmi(&read.matrices["WKK"], &read.matrices["FA2J"]).unwrap(), corrections);
}

/// A bar's card has no taper, no rotary inertia, no shear with I12 and no offsets of mass or neutral axis: with any of these a beam stays one,
/// and what is written and read again has the same mass, inertia and frequencies.
#[test]
fn only_beams_that_say_no_more_than_a_bar_are_written_as_bars() {
    let section = "1.-4,4.-9,1.-9,0.,2.-9,.2";
    let end = |fields: &str| format!("PBEAM,1,1,{section}\n,,,,,,,,\n{fields}\n");
    let taper =
        format!("PBEAM,1,1,{section}\n,,,,,,,,\n,YES,1.,.5-4,3.-9,1.-9,1.-10,2.-9,.1\n,,,,,,,,\n,.8,.7\n");
    let cases = [
        ("plain", end(",.8,.7"), 0),
        ("rotary inertia", end(",.8,.7,,,.03,.03"), 1),
        ("rotary inertia of end B", end(",.8,.7,,,0.,.03"), 1),
        ("mass beside the axis", end(",.8,.7\n,.1,0.,.1,0."), 1),
        ("neutral axis beside the axis", end(",.8,.7\n,,,,,0.,.01,0.,.01"), 1),
        (
            "shear with I12, which a bar's card cannot have",
            end(",.8,.7").replace(",0.,2.-9", ",1.-10,2.-9"),
            1,
        ),
        ("taper", taper, 1),
    ];
    for (what, property, kept) in cases {
        let deck = format!(
            "GRID,1,,0.,0.,0.\nGRID,2,,2.,0.,0.\nSPC1,1,123456,1\nCBEAM,1,1,1,2,0.,1.,0.\nMAT1,1,7.+10,2.7+10,,2700.\n{property}"
        );
        let original = parse_deck("beam.bdf", &deck).unwrap();
        let mut bars = original.clone();
        assert_eq!(coupling::nastran_deck::bars_for_beams(&mut bars), kept, "{what}");
        let read = parse_deck("bars.bdf", &nastran::write_deck(&bars)).unwrap();
        assert_eq!(read.beams[&1].is_beam, kept == 1, "{what}");
        let of = |bulk: &BulkData| {
            let system = System::assemble(&Model::from_bulk(bulk).unwrap()).unwrap();
            (system.mass_properties(), normal_modes(&system, 5).unwrap().omega_rad_s)
        };
        let ((a, omega_a), (b, omega_b)) = (of(&original), of(&read));
        same(a.mass_kg, b.mass_kg, 1e-9, what);
        assert!((a.centre - b.centre).norm() < 1e-9, "{what}");
        assert!((a.inertia_kg_m2 - b.inertia_kg_m2).norm() < 1e-9 * b.inertia_kg_m2.norm(), "{what}");
        for (a, b) in omega_a.iter().zip(&omega_b) {
            same(*a, *b, 1e-8, what);
        }
    }
}
