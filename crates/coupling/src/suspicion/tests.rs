//! Where exactly a number begins to be asked about.

use super::*;
use nastran::parse_deck;

fn boxes(span_m: f64, chord_m: f64) -> Lattice {
    Lattice::trapezoid(1, [0.0, -0.5, 0.0], chord_m, [0.0, span_m - 0.5, 0.0], chord_m, [1, 2])
        .expect("boxes")
}

fn deck(text: &str) -> BulkData {
    parse_deck("units.bdf", text).expect("a deck")
}

#[test]
fn extents_and_mean_chords_are_those_of_the_drawing() {
    assert_eq!(extent([3.0, -1.0, 2.0].into_iter()), 4.0);
    assert_eq!(extent([5.0].into_iter()), 0.0);
    assert_eq!(extent(std::iter::empty()), 0.0);
    let lattice = boxes(4.0, 1.5);
    assert!((mean_chord_m(&lattice, 4.0) - 1.5).abs() < 1e-12);
    assert_eq!(mean_chord_m(&lattice, 0.0), 0.0);
    assert_eq!(mean_chord_m(&lattice, -1.0), 0.0);
}

#[test]
fn a_wing_may_weigh_half_of_solid_steel_and_what_has_no_boxes_anything() {
    let lattice = boxes(2.0, 1.5);
    let area: f64 = lattice.boxes.iter().map(aero::AeroBox::area_m2).sum();
    let limit = HEAVIEST_WING_KG_M3 * (area * SECTION_AREA * mean_chord_m(&lattice, 2.0));
    // 2 m by 1.5 m, sections of 0.105 chords squared, 3900 kg/m3.
    assert!((limit - 3900.0 * 2.0 * 0.105 * 1.5 * 1.5).abs() < 1e-9);
    let mut bulk = deck("GRID,1,,0.,0.,0.\nGRID,2,,0.,1.,0.\nCONM2,5,1,,1.\n");
    let mut with = |kg: f64, lattice: &Lattice| {
        bulk.masses.values_mut().for_each(|mass| mass.mass = kg);
        of_wing(&bulk, lattice)
    };
    assert!(with(limit, &lattice).is_empty());
    let found = with(limit * (1.0 + 1e-9), &lattice);
    assert!(found.len() == 1 && found[0].contains("in grams"), "{found:?}");
    assert!(with(limit, &Lattice::default()).is_empty());
    assert!(with(0.0, &lattice).is_empty());
}

#[test]
fn a_span_of_the_largest_aircraft_is_none_too_much() {
    let bulk = deck("GRID,1,,0.,0.,0.\n");
    assert!(of_wing(&bulk, &boxes(60.0, 1.0)).is_empty());
    assert_eq!(of_wing(&bulk, &boxes(60.001, 1.0)).len(), 1);
}

#[test]
fn grids_and_boxes_are_compared_both_ways() {
    let grids = |span: f64| deck(&format!("GRID,1,,0.,0.,0.\nGRID,2,,0.,{span:.4},0.\n"));
    for (grid_span, box_span, asked) in [
        (1000.0, 1.0, true),
        (1.0, 1000.0, true),
        (1.0, 1.0, false),
        (0.5, 1.0, false),
        (3000.0, 1.0, false),
        (333.0, 1.0, true),
        (332.9, 1.0, false),
    ] {
        let found = grids_beside_boxes(&grids(grid_span), box_span);
        assert_eq!(found.is_some(), asked, "{grid_span} beside {box_span}: {found:?}");
        assert!(
            found.is_none_or(|said| said.contains(&format!("{grid_span:.4} and the boxes {box_span:.4}")))
        );
    }
}

#[test]
fn materials_at_their_bounds_are_not_asked_about() {
    let one = |e: f64, rho: f64| {
        let mut bulk = deck("MAT1,7,7.+10,,.3,2700.\n");
        bulk.materials.values_mut().for_each(|material| (material.e, material.rho) = (e, rho));
        materials(&bulk).len()
    };
    for (e, rho, count) in [
        (SOFTEST_PA, LIGHTEST_KG_M3, 0),
        (SOFTEST_PA * 0.999, LIGHTEST_KG_M3, 1),
        (0.0, 1000.0, 0),
        (-1.0, 1000.0, 0),
        (1.0, 1000.0, 1),
        (SOFTEST_PA, LIGHTEST_KG_M3 * 0.999, 1),
        (SOFTEST_PA, 0.0, 0),
        (SOFTEST_PA, HEAVIEST_KG_M3, 0),
        (SOFTEST_PA, HEAVIEST_KG_M3 * 1.001, 1),
        (1.0, 1e-3, 2),
        (1.0, 1e9, 2),
    ] {
        assert_eq!(one(e, rho), count, "{e} Pa, {rho} kg/m3");
    }
}
