//! Trim of a user's deck beyond its published numbers: links, stations, divergence, plate splines, and refusals.

use fullaircraft::{TrimDeck, deck_cases};
use nastran::{BulkData, parse_deck};
use std::path::Path;

/// HA144A with more cards, or with some lines in other words.
fn deck(more: &str, change: &[(&str, &str)]) -> BulkData {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/published/decks/ha144a_fsw.bdf");
    let mut text = std::fs::read_to_string(path).expect("the shipped deck");
    for (from, to) in change {
        assert!(text.contains(from), "{from}");
        text = text.replacen(from, to, 1);
    }
    let at = text.find("ENDDATA").unwrap_or(text.len());
    text.insert_str(at, more);
    parse_deck("ha144a", &text).expect("cards that are right")
}

fn near(a: f64, b: f64, share: f64) {
    assert!((a - b).abs() <= share * b.abs(), "{a} {b}");
}

#[test]
fn subcases_of_the_deck_are_its_trims() {
    let bulk = deck("", &[]);
    let cases = deck_cases(&bulk).unwrap();
    let trims: Vec<(u32, u32)> = cases.iter().map(|case| (case.subcase.id, case.trim.id)).collect();
    assert_eq!(trims, [(1, 1), (2, 2)]);
    assert!(bulk.in_subcase(&cases[0].subcase).is_ok());
    let gone = deck("", &[("SPC = 1", "SPC = 9")]);
    let error = gone.in_subcase(&deck_cases(&gone).unwrap()[0].subcase).unwrap_err();
    assert!(error.to_string().contains("SPC 9"), "{error}");
    let gone = deck("", &[("TRIM = 2", "TRIM = 9")]);
    assert!(deck_cases(&gone).unwrap_err().to_string().contains("TRIM 9"));
}

#[test]
fn two_halves_of_a_control_linked_one_to_one_are_the_control() {
    let whole = deck("", &[]);
    let card = whole.trims[&1].clone();
    let expected = TrimDeck::new(&whole, 0.9).unwrap().trim_card(&card).unwrap();
    // the canard's boxes in two lists; each half is a control, the second follows the first
    let mut halves = deck("AELINK,1,OTHER,ELEV,-1.0\n", &[]);
    let (id, surface) = halves.surfaces.iter().next().map(|(id, surface)| (*id, surface.clone())).unwrap();
    let boxes = halves.box_lists[&surface.parts[0].1].boxes.clone();
    let (one, two) = boxes.split_at(boxes.len() / 2);
    let list =
        |id: u32, boxes: &[u32]| nastran::Aelist { id, boxes: boxes.to_vec(), span: surface.span.clone() };
    for (at, boxes, label) in [(0, one, "ELEV"), (1, two, "OTHER")] {
        let list = list(9000 + at, boxes);
        let mut half = surface.clone();
        (half.id, half.label) = (id + 1000 * at, label.to_owned());
        half.parts[0].1 = list.id;
        halves.box_lists.insert(list.id, list);
        halves.surfaces.insert(half.id, half);
    }
    let found = TrimDeck::new(&halves, 0.9).unwrap().trim_card(&card).unwrap();
    for label in ["ANGLEA", "ELEV"] {
        near(found.values[label], expected.values[label], 1e-9);
    }
    near(found.values["OTHER"], expected.values["ELEV"], 1e-9);
    // a link to nothing, and one that is given a value as well
    let error = TrimDeck::new(&deck("AELINK,1,ELEV,FLAP,1.0\n", &[]), 0.9).unwrap_err();
    assert!(error.to_string().contains("FLAP of AELINK"), "{error}");
    let linked = TrimDeck::new(&halves, 0.9).unwrap();
    let mut both = card;
    both.fixed.push(("OTHER".to_owned(), 0.1));
    assert!(linked.trim_card(&both).unwrap_err().to_string().contains("AELINK"));
}

#[test]
fn a_station_of_all_boxes_has_the_lift_of_the_aircraft() {
    let more = "AECOMP,ALL,CAERO,1000,1100\nAECOMP,CANARD,CAERO,1000\n\
                MONPNT1,TOTAL   ,all boxes\n,123456,ALL,0,15.,0.,0.\n\
                MONPNT1,FRONT   ,canard\n,123456,CANARD,0,15.,0.,0.\n";
    let bulk = deck(more, &[]);
    let trimmed = TrimDeck::new(&bulk, 0.9).unwrap().trim_card(&bulk.trims[&1]).unwrap();
    let lift: f64 = trimmed.lift.iter().sum();
    near(trimmed.monitors["TOTAL"][2], lift, 1e-12);
    // the half aircraft weighs 8000 lbf
    near(trimmed.monitors["TOTAL"][2], 8000.0, 2e-6);
    let canard: f64 = trimmed.lift[..8].iter().sum();
    near(trimmed.monitors["FRONT"][2], canard, 1e-12);
    let error =
        TrimDeck::new(&deck("MONPNT1,TOTAL   ,label\n,123456,ALL,0,15.,0.,0.\n", &[]), 0.9).unwrap_err();
    assert!(error.to_string().contains("AECOMP ALL"), "{error}");
}

#[test]
fn at_divergence_the_trim_is_refused_and_just_below_it_the_lift_slope_has_grown_without_bound() {
    let bulk = deck("", &[]);
    let deck = TrimDeck::new(&bulk, 0.9).unwrap();
    let first = deck.divergence_pressures()[0];
    let slope = |q: f64| deck.derivatives(q, fullaircraft::Elastic::Restrained)["ANGLEA"][2].abs();
    // near a simple pole the slope goes with 1/(q_D - q)
    near(slope(first * (1.0 - 1e-4)) / slope(first * (1.0 - 1e-3)), 10.0, 0.01);
    let error = deck.trim(first * 1.01, &bulk.trims[&1].fixed).unwrap_err();
    assert!(error.to_string().contains("diverge"), "{error}");
}

#[test]
fn what_limits_a_trim_is_said() {
    let bulk = deck("", &[]);
    let deck = TrimDeck::new(&bulk, 0.9).unwrap();
    let fixed = |names: &[&str]| names.iter().map(|name| ((*name).to_owned(), 0.0)).collect::<Vec<_>>();
    let error = deck.trim(40.0, &fixed(&["PITCH", "URDD3"])).unwrap_err().to_string();
    assert!(error.contains("3 free variables") && error.contains("URDD5"), "{error}");
}

#[test]
fn a_deck_with_turned_axes_or_other_splines_is_refused_in_words() {
    let turned = "CORD2R,77,,0.,0.,0.,0.,0.,-1.,+\n+,-1.,0.,0.\n";
    let mut bulk = deck(turned, &[]);
    bulk.aero_reference.as_mut().unwrap().acsid = 77;
    let error = TrimDeck::new(&bulk, 0.9).unwrap_err();
    assert!(error.to_string().contains("ACSID"), "{error}");
    let mut bulk = deck("SPLINE6,900,1000,1,,1100,,IPS\n", &[]);
    bulk.splines.clear();
    let error = TrimDeck::new(&bulk, 0.9).unwrap_err();
    assert!(error.to_string().contains("SPLINE6"), "{error}");
}

#[test]
fn a_plate_spline_follows_rigid_motions_and_refuses_grids_on_a_line() {
    // The balance uses the splined rigid motions: only if they are exact does the lift come out as the weight.
    let plate = |set: &str| {
        let mut bulk = deck(set, &[]);
        let card = bulk.splines.values().next().unwrap().clone();
        for spline in bulk.splines.values_mut() {
            let panel = &bulk.panels[&spline.panel];
            spline.kind = nastran::SplineKind::Plate;
            spline.boxes = if panel.id == 1000 { (1000, 1007) } else { (1100, 1131) };
            spline.set = 700;
        }
        (bulk, card)
    };
    let (bulk, _) = plate("SET1,700,98,100,111,112,121,122\n");
    let trimmed = TrimDeck::new(&bulk, 0.9).unwrap().trim_card(&bulk.trims[&1]).unwrap();
    near(trimmed.lift.iter().sum(), 8000.0, 1e-9);
    let (line, _) = plate("SET1,700,97,98,99,100\n");
    let error = TrimDeck::new(&line, 0.9).unwrap_err();
    assert!(error.to_string().contains("do not determine a plate"), "{error}");
}

#[test]
fn an_antisymmetric_trim_knows_neither_camber_nor_offsets_and_follows_the_roll_in_proportion() {
    let change = [
        ("SPC1,1,1246,90\n", "SPC1,1,12356,90\n"),
        ("SPC1,1,246,97,98,99,100\n", "SPC1,1,135,97,98,99,100\n"),
        ("SUPORT,90,35\n", "SUPORT,90,4\nAESTAT,601,ROLL\nAESTAT,602,URDD4\n"),
    ];
    let mut bulk = deck("", &change);
    let symmetric = bulk.aero_reference.as_mut().expect("AEROS");
    symmetric.symmetry = -1;
    assert!(bulk.matrices.contains_key("W2GJ"), "the twist that must not count");
    bulk.matrices.insert("FA2J".to_owned(), nastran::Dmi::column_vector("FA2J", vec![0.1; 40]));
    let trim_deck = TrimDeck::new(&bulk, 0.9).unwrap();
    let rolled = |roll: f64| {
        let all = ["ANGLEA", "PITCH", "URDD3", "URDD5", "ELEV"].map(|label| (label.to_owned(), 0.0));
        let fixed: Vec<_> = all.into_iter().chain([("ROLL".to_owned(), roll)]).collect();
        trim_deck.trim(40.0, &fixed).unwrap().values["URDD4"]
    };
    assert!(
        rolled(0.0).abs() < 1e-12 * rolled(0.1).abs(),
        "nothing rolls an aircraft that does not roll: {}",
        rolled(0.0)
    );
    near(rolled(0.2), 2.0 * rolled(0.1), 1e-9);
    assert!(rolled(0.1) * rolled(-0.1) < 0.0 && rolled(0.1) != 0.0);
}
