//! What is refused, and that the message says what, where and what to do.

use crate::common::{beam, section, system};
use nastran::parse_deck;
use structure::{Flexibility, Model, System};

fn message(deck: &str) -> String {
    let bulk = parse_deck("wing.bdf", deck).expect("the cards are well formed");
    match Model::from_bulk(&bulk).and_then(|model| System::assemble(&model)) {
        Ok(_) => "accepted".to_owned(),
        Err(error) => error.to_string(),
    }
}

#[test]
fn an_undefined_property_is_blamed_on_the_element() {
    let deck = "GRID,1,,0.,0.,0.\nGRID,2,,0.,2.,0.\nPBAR,3,1,1.-4,1.-9,1.-9,2.-9\nPBAR,4,1,1.-4,1.-9,1.-9,2.-9\n\
                MAT1,1,7.+10,,.3\nCBAR,1,7,1,2,0.,0.,1.\n";
    assert_eq!(
        message(deck),
        "wing.bdf:6:1: CBAR 1 refers to PBAR 7, which is not in the deck (hint: there are PBAR 3, 4)"
    );
}

#[test]
fn other_undefined_references_are_blamed_on_their_card() {
    let deck = "GRID,1,,0.,0.,0.\nCONM2,5,9,,1.0\n";
    let expected =
        "wing.bdf:2:1: CONM2 5 refers to GRID 9, which is not in the deck (hint: there are GRID 1)";
    assert_eq!(message(deck), expected);
    let deck = beam(1, 1, 2.0, 0.0) + "PBAR,1,6,1.-4,1.-9,1.-9,2.-9\n";
    let expected =
        "wing.bdf:4:1: PBAR 1 refers to MAT1 6, which is not in the deck (hint: the deck has no MAT1)";
    assert_eq!(message(&deck), expected);
}

#[test]
fn a_beam_along_its_orientation_vector_is_refused() {
    let deck = "GRID,1,,0.,0.,0.\nGRID,2,,0.,0.,2.\nCBAR,1,1,1,2,0.,0.,1.\n".to_owned() + &section();
    let expected = "wing.bdf:3:1: beam 1: orientation vector (0, 0, 1) is zero or along the beam (hint: give a \
                    vector that spans bending plane 1 together with the element axis)";
    assert_eq!(message(&deck), expected);
}

#[test]
fn a_grid_that_follows_two_links_is_refused() {
    let deck = "GRID,1,,0.,0.,0.\nGRID,2,,0.,2.,0.\nGRID,3,,1.,2.,0.\nRBE2,1,1,123456,3\nRBE2,2,2,123,3\n";
    let text = message(deck);
    assert!(text.starts_with("wing.bdf:5:1: RBE2 2: GRID 3 component 1 already depends on RBE2 1"), "{text}");
}

#[test]
fn a_circle_of_links_is_refused() {
    let deck = "GRID,1,,0.,0.,0.\nGRID,2,,0.,2.,0.\nRBE2,1,1,123456,2\nRBE2,2,2,123456,1\n";
    assert!(message(deck).contains("follows itself in a circle of rigid links"), "{}", message(deck));
}

#[test]
fn a_clamped_dependent_grid_is_refused() {
    let deck = "GRID,1,,0.,0.,0.\nGRID,2,,0.,2.,0.\nRBE2,1,1,123456,2\nSPC1,1,3,2\n";
    let expected = "wing.bdf:4:1: GRID 2 component 3 is clamped, but it follows a rigid link (hint: ";
    assert!(message(deck).starts_with(expected), "{}", message(deck));
}

#[test]
fn a_component_that_nothing_holds_is_named() {
    // Plane 1, plane 2 and extension are held at the root, twist is not.
    let system = system(&(beam(1, 1, 2.0, 0.0) + &section() + "SPC1,1,12346,1\nSPC1,1,12346,2\n"));
    let error = Flexibility::new(&system).unwrap_err();
    assert_eq!(error.loose.len(), 1);
    assert_eq!(error.loose[0].1, 5);
    assert!(error.to_string().contains("component 5"), "{error}");
}

#[test]
fn a_free_structure_has_six_loose_motions_however_fine_it_is() {
    for n in [1, 3, 40, 300, 1000] {
        let error = Flexibility::new(&system(&(beam(1, n, 2.0, 0.3) + &section()))).unwrap_err();
        assert_eq!(error.loose.len(), 6, "{n} elements: {error}");
    }
}

#[test]
fn a_slender_cantilever_is_not_taken_for_loose() {
    let n = 1000;
    let system = system(&(beam(1, n, 2.0, 0.0) + &section() + "SPC1,1,123456,1\n"));
    assert!(Flexibility::new(&system).is_ok());
}

#[test]
fn a_mechanism_of_pin_flags_is_named() {
    // A hinge in plane 1 in the middle of a cantilever.
    let mut deck = beam(1, 4, 2.0, 0.0) + &section() + "SPC1,1,123456,1\n";
    deck = deck.replace("CBAR,2,1,2,3,0.,0.,1.\n", "CBAR,2,1,2,3,0.,0.,1.\n,6\n");
    let error = Flexibility::new(&system(&deck)).unwrap_err();
    assert_eq!(error.loose.len(), 1, "{error}");
    let (grid, component) = error.loose[0];
    assert!((2..=5).contains(&grid) && [3, 4].contains(&component), "{error}");
}

#[test]
fn a_hinge_in_a_held_beam_carries_no_moment() {
    // Clamped on both sides, hinge in the middle: two cantilevers share the force.
    let deck = beam(1, 2, 2.0, 0.0) + &section() + "SPC1,1,123456,1,3\n";
    let hinged = deck.replace("CBAR,1,1,1,2,0.,0.,1.\n", "CBAR,1,1,2,1,0.,0.,1.\n,6\n");
    assert_ne!(deck, hinged);
    let system = system(&hinged);
    let u = crate::common::displaced(&system, &[(2, 3, 5.0)]);
    // Element 1 is hinged at grid 2, element 2 is not: grid 2 turns with the second cantilever.
    let cantilever = 5.0 / 2.0 / (3.0 * crate::common::E * crate::common::I[0]);
    crate::common::close(crate::common::at(&system, &u, 2, 3), cantilever, 1e-10, "deflection");
}

#[test]
fn a_motion_without_stiffness_is_named() {
    // Twist is touched by the beam but has neither stiffness nor inertia.
    let section = section()
        .replace(&format!("{:.1E}\n", crate::common::I[2]), "0.\n")
        .replace(&format!("{:.1E}", crate::common::G), "0.");
    let deck = beam(1, 1, 2.0, 0.0) + &section + "SPC1,1,123456,1\nSPC1,1,1346,2\n";
    let error = Flexibility::new(&system(&deck)).unwrap_err();
    assert_eq!(error.loose, [(2, 5)], "{error}");
}

#[test]
fn a_grid_that_nothing_touches_is_held_and_known() {
    let system = system(&(beam(1, 2, 2.0, 0.0) + &section() + "SPC1,1,123456,1\nGRID,50,,5.,5.,5.\n"));
    assert!(Flexibility::new(&system).is_ok());
    let attached = |id: u32| system.is_attached(system.node_index(id).unwrap());
    assert!(attached(1) && attached(3) && !attached(50));
}

#[test]
fn a_negative_mass_is_refused_and_an_inertia_that_no_body_has_only_said_as_nastran_does() {
    let body = |inertia: &str| message(&format!("GRID,1,,0.,0.,0.\nCONM2,5,1,,1.0\n,{inertia}\n"));
    assert_eq!(body("0.,,.1,,,.1"), "accepted", "a thin rod has none about its own axis");
    assert_eq!(body("-.2,,.1,,,.1"), "accepted", "computed with, as several cards may sum up to a body");
    let negative = message("GRID,1,,0.,0.,0.\nCONM2,5,1,,-1.0\n");
    assert!(negative.starts_with("wing.bdf:2:1: CONM2 5 has the negative mass -1"), "{negative}");
}
