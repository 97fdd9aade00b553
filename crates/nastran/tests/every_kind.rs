//! Every kind of cards goes through reading, counting, numbering, joining, mirroring and writing. The list of kinds and
//! the samples are compared name by name, so that a kind without a sample fails.

use crate::common::content;
use nastran::{BulkData, CARD_KINDS, Family, Step, parse_deck, write_deck};
use std::collections::{BTreeMap, BTreeSet};

/// A card of each name, and what those refer to that must be there.
const SAMPLES: &str = include_str!("every_kind.bdf");

/// Boxes 1001 to 1004 in two strips of two; the strips count from the other side.
fn box_images() -> BTreeMap<u32, u32> {
    [(1001, 1003), (1002, 1004), (1003, 1001), (1004, 1002)].into()
}

/// Kinds that an image has no cards of, said beside their types.
const NO_IMAGE: &str = "\
    splines monitors constraint_unions equation_unions point_loads scalar_loads line_loads cross_loads beam_loads pressures \
     gravities spins accelerations load_sums enforced temperatures aero_reference trim_variables trims divergences aero_links aero_components \
     component_lists supports eigen_methods unsteady_reference flutters flutter_factors reduced_frequencies \
     damping_tables gusts dynamic_loads dynamic_sums load_areas direct_matrices frequencies time_steps \
     function_tables spectrum_tables spectra";
/// Kinds that are read only.
const NOT_WRITTEN: &str = "\
    constraint_unions equation_unions aero_reference trim_variables trims divergences aero_links aero_components \
     component_lists supports eigen_methods unsteady_reference flutters flutter_factors reduced_frequencies \
     damping_tables gusts dynamic_loads load_areas direct_matrices frequencies time_steps function_tables \
     spectrum_tables spectra";

fn samples() -> BulkData {
    parse_deck("samples.bdf", SAMPLES).unwrap_or_else(|error| panic!("{error}"))
}

/// The samples without a GENEL, which has no image.
fn with_image() -> BulkData {
    BulkData { general: BTreeMap::new(), ..samples() }
}

/// What a deck says by field, as text without places: `grids: {...}`.
fn fields(deck: &BulkData) -> BTreeMap<String, String> {
    let mut fields: BTreeMap<String, String> = BTreeMap::new();
    let mut name = String::new();
    for line in content(deck).lines() {
        let head = line.strip_prefix("    ").filter(|rest| !rest.starts_with([' ', '}', ']', ')']));
        if let Some((field, _)) = head.and_then(|rest| rest.split_once(':')) {
            field.clone_into(&mut name);
        }
        fields.entry(name.clone()).or_default().push_str(line);
    }
    fields
}

/// Numbers to ten digits: sixteen characters do not hold all of a section's.
fn rounded(text: &str) -> String {
    let word = |word: &str| match word.trim_end_matches(',').parse::<f64>() {
        Ok(number) => format!("{number:.9e}"),
        Err(_) => word.to_owned(),
    };
    text.split_whitespace().map(word).collect::<Vec<_>>().join(" ")
}

/// Fields that hold something.
fn filled(deck: &BulkData) -> BTreeSet<String> {
    let is_empty = |text: &str| text.ends_with("{},") || text.ends_with("[],") || text.ends_with("None,");
    fields(deck).into_iter().filter(|(_, text)| !is_empty(text)).map(|(name, _)| name).collect()
}

fn kinds(but: &str) -> Vec<&'static str> {
    CARD_KINDS
        .iter()
        .map(|kind| kind.field)
        .filter(|field| but.split(' ').all(|other| other != *field))
        .collect()
}

#[test]
fn every_name_of_every_kind_has_a_sample_that_is_read() {
    let deck = samples();
    assert_eq!(deck.unread_cards(), None);
    for kind in CARD_KINDS {
        for name in kind.names {
            let card = format!("{name},");
            assert!(SAMPLES.lines().any(|line| line.starts_with(&card)), "no sample of {name}");
        }
        assert!(filled(&deck).contains(kind.field), "the samples of {:?} fill nothing", kind.names);
    }
}

#[test]
fn every_element_is_counted() {
    let counts = samples().element_counts();
    let elements = CARD_KINDS.iter().filter(|kind| kind.family.is_element());
    for kind in elements {
        // Other forms of a rigid body count as the card that it is written as.
        let counted: usize = kind.names.iter().filter_map(|name| counts.get(name)).sum();
        assert_eq!(counted, kind.names.len(), "{:?}: {counts:?}", kind.names);
        let are_alike = kind.names.contains(&"RBE1");
        assert!(are_alike || kind.names.iter().all(|name| counts.get(name) == Some(&1)), "{counts:?}");
    }
}

#[test]
fn every_kind_that_is_written_is_read_again_as_it_was() {
    let deck = samples();
    let text = write_deck(&deck);
    let again = parse_deck("again.bdf", &text).unwrap_or_else(|error| panic!("{error}"));
    let (before, after) = (fields(&deck), fields(&again));
    for field in kinds(NOT_WRITTEN) {
        assert_eq!(rounded(&before[field]), rounded(&after[field]), "{field}");
    }
    assert!(NOT_WRITTEN.split(' ').all(|field| !filled(&again).contains(field)));
}

#[test]
fn every_number_is_raised_and_nothing_else() {
    let step = Step { cards: 100_000, boxes: 1_000_000 };
    let deck = samples();
    let raised = deck.clone().raised(step, "").expect("numbers that do not meet");
    let (before, after) = (fields(&deck), fields(&raised));
    // Sets of constraints and loads, and what only the case control and names refer to.
    let keep = [
        "equation_unions",
        "constraint_unions",
        "load_sums",
        "trims",
        "divergences",
        "aero_links",
        "component_lists",
        "aero_reference",
        "flutters",
        "flutter_factors",
        "reduced_frequencies",
        "damping_tables",
        "gusts",
        "dynamic_loads",
        "dynamic_sums",
        "frequencies",
        "time_steps",
        "function_tables",
        "spectrum_tables",
        "spectra",
    ];
    for field in kinds(&keep.join(" ")) {
        assert_ne!(before[field], after[field], "{field} keeps its numbers");
    }
    // Raising by nothing changes nothing, and both models fit into one deck.
    let same = deck.clone().raised(Step { cards: 0, boxes: 0 }, "").expect("the same numbers");
    assert_eq!(fields(&same), before);
    let mut both =
        BulkData { aero_reference: None, unsteady_reference: None, trims: BTreeMap::new(), ..deck };
    both.divergences.clear();
    (both.flutters, both.flutter_factors, both.damping_tables) = Default::default();
    (both.constraint_unions, both.equation_unions, both.load_sums) = Default::default();
    (both.gusts, both.dynamic_loads, both.dynamic_sums, both.time_steps) = Default::default();
    (both.function_tables, both.spectrum_tables) = Default::default();
    both.aero_components.clear();
    both.component_lists.clear();
    both.join(raised).expect("numbers above all others");
    for (name, count) in samples().element_counts() {
        assert_eq!(both.element_counts()[name], 2 * count, "{name}");
    }
}

#[test]
fn every_kind_has_an_image_or_says_that_it_has_none() {
    let deck = with_image();
    let boxes = box_images();
    let mut placed = deck.clone();
    for mass in placed.masses.values_mut() {
        mass.cid = 0;
    }
    let image = placed.mirrored(&boxes).unwrap_or_else(|error| panic!("{error}"));
    let general = CARD_KINDS.iter().find(|kind| kind.names == ["GENEL"]).expect("a kind").field;
    for field in kinds(NO_IMAGE).into_iter().filter(|field| *field != general) {
        assert!(filled(&image).contains(field), "{field} vanishes from the image");
    }
    assert!(NO_IMAGE.split(' ').all(|field| !filled(&image).contains(field)));
    // The image of the image: all but coordinates, which are in the basic system now.
    let twice = image.mirrored(&boxes).unwrap_or_else(|error| panic!("{error}"));
    let basic = twice.mirrored(&boxes).unwrap_or_else(|error| panic!("{error}"));
    for (field, text) in fields(&image) {
        assert_eq!(text.replace("-0.0", "0.0"), fields(&basic)[&field].replace("-0.0", "0.0"), "{field}");
    }
}

#[test]
fn numbers_that_a_family_shares_are_refused_across_its_kinds() {
    for (family, a, b) in [
        // Those of two kinds are kept: `cards.rs`.
        (Family::Element, "CELAS1,1,1,1,2", "CELAS2,1,4.,1,2"),
        (Family::MassElement, "CONM2,1,1,,2.", "CMASS2,1,4.,1,2"),
        (Family::RigidElement, "RBE2,1,1,3,2", "RBAR,1,1,2,123456"),
        (Family::Material, "MAT1,1,4.,,.3", "MAT8,1,4.,3.,.2,1."),
    ] {
        let error = parse_deck("t.bdf", &format!("{a}\n{b}\n")).expect_err("one number");
        assert!(error.message.contains("has the number of another"), "{family:?}: {error}");
    }
}
