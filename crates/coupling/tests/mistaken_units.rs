//! Which numbers of a wing are asked about because their unit was probably mistaken, and which are not.

use aero::Lattice;
use coupling::suspicion::of_wing;
use nastran::parse_deck;

fn said(deck: &str, span_m: f64, chord_m: f64) -> Vec<String> {
    let bulk = parse_deck("units.bdf", deck).expect("a deck");
    let lattice =
        Lattice::trapezoid(1, [0.0; 3], chord_m, [0.0, span_m, 0.0], chord_m, [2, 2]).expect("boxes");
    of_wing(&bulk, &lattice)
}

/// Grids over a span.
fn grids(span: f64) -> String {
    format!("GRID,1,,0.,1.5,0.\nGRID,2,,0.,{:.4},0.\n", 1.5 + span)
}

#[test]
fn a_span_beyond_any_aircraft_is_millimetres() {
    assert!(said("GRID,1,,0.,0.,0.\n", 60.0, 1.0).is_empty());
    let found = said("GRID,1,,0.,0.,0.\n", 61.0, 1.0);
    assert!(found.len() == 1 && found[0].contains("the boxes span 61.0000 m"), "{found:?}");
}

#[test]
fn boxes_and_grids_a_thousandfold_apart_are_in_two_units() {
    for (span, asked) in [
        (2.0, false),
        (660.0, false),
        (668.0, true),
        (2000.0, true),
        (5990.0, true),
        (6010.0, false),
        (2.0 / 320.0, false),
        (2.0 / 1000.0, true),
        (2.0 / 340.0, true),
    ] {
        let found = said(&grids(span), 2.0, 1.0);
        assert_eq!(found.len(), usize::from(asked), "{span}: {found:?}");
        assert!(found.iter().all(|said| said.contains("a thousandfold apart")), "{found:?}");
    }
    // one grid spans nothing
    assert!(said("GRID,1,,0.,2.,0.\n", 2.0, 1.0).is_empty());
}

#[test]
fn materials_that_no_wing_is_made_of_are_asked_about() {
    let iso = |e: &str, rho: &str| said(&format!("MAT1,7,{e},,.3,{rho}\n"), 2.0, 1.0);
    assert!(iso("1.+6", "5.").is_empty());
    assert!(iso("7.+10", "23000.").is_empty());
    assert!(iso("7.+10", "0.").is_empty());
    for (e, rho, word) in [
        ("9.9+5", "1000.", "MAT1 7 has 990000 Pa, softer than rubber"),
        ("7.+10", "4.9", "MAT1 7 has 4.9 kg/m3, lighter than foam"),
        ("7.+10", "23001.", "MAT1 7 has 23001 kg/m3, heavier than any metal"),
    ] {
        let found = iso(e, rho);
        assert!(found.len() == 1 && found[0].contains(word), "{found:?}");
    }
    let ply = said("MAT8,9,7.+5,5.+5,.3,1.+9,,,2.7-9\n", 2.0, 1.0);
    assert!(ply.len() == 2 && ply.iter().all(|said| said.contains("MAT8 9")), "{ply:?}");
}

/// 2 m by 1.5 m with sections of 0.105 chords squared: 0.4725 m³, 1842.75 kg at half of solid steel.
#[test]
fn a_wing_heavier_than_half_of_solid_steel_is_in_grams() {
    let with = |kg: f64| said(&format!("GRID,1,,0.,0.,0.\nCONM2,5,1,,{kg:.3}\nCONM2,6,1,,100.\n"), 2.0, 1.5);
    assert!(with(1742.0).is_empty(), "{:?}", with(1742.0));
    let found = with(1744.0);
    assert!(found.len() == 1 && found[0].contains("masses of 1844.0000 kg"), "{found:?}");
}
