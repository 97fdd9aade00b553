//! A wing given as a Nastran deck is the same wing: one path from `BulkData` on.

use aero::{Corrections, Flow};
use coupling::{ElasticWing, Mount, SteadyCase, SteadyModel, WingFile};
use std::path::{Path, PathBuf};

fn data(file: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/tuflex").join(file)
}

fn shipped() -> PathBuf {
    data("wing_beam.ron")
}

/// Writes the shipped wing as a deck and a wing file that names it; gives the folder.
fn as_deck(name: &str, change: impl Fn(String) -> String) -> PathBuf {
    wing_as_deck(&shipped(), name, change)
}

fn wing_as_deck(wing: &Path, name: &str, change: impl Fn(String) -> String) -> PathBuf {
    let folder = std::env::temp_dir().join(format!("wingroot-deck-{}-{name}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("a temporary folder");
    let bulk = WingFile::read(wing).and_then(|file| file.bulk(Mount::Tunnel)).expect("the shipped wing");
    let deck = change(nastran::write_deck(&bulk));
    std::fs::write(folder.join("wing.bdf"), deck).expect("a temporary file");
    let wing = "Wing(name: \"as a deck\", source: Deck((file: \"wing.bdf\", fairing_panels: [200001], spline_set: 1)), \
                root_plane: Symmetric(-0.09), balance: (x_m: 0.075, y_m: 0.0, z_m: 0.0), \
                correction: (chord_strips: 12, span_order: 4))";
    std::fs::write(folder.join("wing.ron"), wing).expect("a temporary file");
    folder
}

#[test]
fn the_shipped_wings_as_decks_have_the_same_loads() {
    has_the_same_loads(&shipped(), "beam");
    has_the_same_loads(&data("wing.ron"), "shells-and-solids");
}

fn has_the_same_loads(wing: &Path, name: &str) {
    let folder = wing_as_deck(wing, name, |deck| deck);
    let (_, from_deck) = ElasticWing::read(&folder.join("wing.ron")).expect("the deck is read");
    std::fs::remove_dir_all(&folder).expect("a temporary folder");
    let (_, parametric) = ElasticWing::read(wing).expect("the shipped wing");
    assert_eq!(from_deck.lattice.len(), 708);
    assert!(from_deck.correctable.places == parametric.correctable.places, "boxes differ");
    assert_eq!(from_deck.controls.len(), 3);
    let case = SteadyCase {
        flow: Flow { v_m_s: 40.0, rho_kg_m3: 1.225 },
        alpha_rad: 0.05,
        controls_rad: vec![0.1, -0.05, 0.02],
    };
    let neutral = Corrections::neutral(672);
    let loads = |wing: &ElasticWing| {
        wing.root_loads(std::slice::from_ref(&case), &neutral).expect("no divergence")[0].to_array()
    };
    for (deck, ours) in loads(&from_deck).into_iter().zip(loads(&parametric)) {
        // W2GJ passes through fields of 8 characters: 5e-6 of each slope at most
        assert!((deck / ours - 1.0).abs() < 1e-5, "{deck} {ours}");
    }
}

#[test]
fn an_undefined_property_is_refused_where_the_card_stands() {
    let folder = as_deck("property", |deck| {
        let is_property = |line: &&str| line.starts_with("PBEAM");
        let first = deck.lines().find(is_property).expect("the wing has beams").to_owned();
        // the first PBEAM and its continuation lines go
        let mut gone = false;
        let keep = |line: &str| {
            if line == first {
                gone = true;
                return false;
            }
            if gone && (line.starts_with('+') || line.starts_with('*') || line.starts_with(' ')) {
                return false;
            }
            gone = false;
            true
        };
        let mut keep = keep;
        deck.lines().filter(|line| keep(line)).collect::<Vec<_>>().join("\n") + "\n"
    });
    let message = ElasticWing::read(&folder.join("wing.ron")).expect_err("a property is missing").to_string();
    std::fs::remove_dir_all(&folder).expect("a temporary folder");
    let place = message.split("wing.bdf:").nth(1).expect("the deck is named");
    let line = place.split(':').next().and_then(|number| number.parse::<usize>().ok());
    assert!(line.is_some_and(|line| line > 1), "{message}");
    assert!(message.contains("propert") && message.contains("hint"), "{message}");
}

#[test]
fn a_spline_grid_that_no_element_holds_is_refused() {
    let folder =
        as_deck("stray", |deck| deck.replace("ENDDATA", "GRID,77,,0.,1.,0.\nSET1,9,1001,77,1037\nENDDATA"));
    let file = folder.join("wing.ron");
    let text =
        std::fs::read_to_string(&file).expect("a temporary file").replace("spline_set: 1", "spline_set: 9");
    std::fs::write(&file, text).expect("a temporary file");
    let message = ElasticWing::read(&file).expect_err("grid 77 hangs on nothing").to_string();
    std::fs::remove_dir_all(&folder).expect("a temporary folder");
    assert!(message.contains("grid 77, which no element holds") && message.contains("RBE2"), "{message}");
}
