//! Lattices, control surfaces and camber from decks, and what is refused.

#![expect(clippy::unwrap_used, reason = "a helper of tests may fail the test where it stands")]

use aero::{ControlSurface, Lattice, camber_and_twist};
use nastran::{BulkData, parse_deck};

fn deck(cards: &str) -> BulkData {
    parse_deck("wing.bdf", &format!("BEGIN BULK\n{cards}ENDDATA\n")).unwrap()
}

const WING: &str = "CAERO1,1001,1,0,,,21,22,1\n,0.,0.,0.,1.,1.,2.,0.,.5\n\
    CAERO1,1,1,0,2,3,,,1\n,3.,0.,0.,1.,3.,1.,0.,1.\nPAERO1,1\n\
    AEFACT,21,0.,.5,.75,1.\nAEFACT,22,0.,.25,1.\n";

#[test]
fn boxes_are_numbered_chordwise_first_and_panels_rise() {
    let lattice = Lattice::from_bulk(&deck(WING)).unwrap();
    let ids: Vec<u32> = lattice.boxes.iter().map(|panel| panel.id).collect();
    assert_eq!(ids, [1, 2, 3, 4, 5, 6, 1001, 1002, 1003, 1004, 1005, 1006]);
    let wing = &lattice.surfaces[1];
    assert_eq!((wing.id, wing.first_box, wing.chordwise, wing.spanwise), (1001, 6, 2, 3));
    // second box of the second strip: y 1.0 to 1.5, from 1/4 of the chord to the trailing edge
    let corners = &lattice.boxes[lattice.index_of(1004).unwrap()].corners;
    assert_eq!((corners[0].x, corners[0].y), (0.5 + 0.75 / 4.0, 1.0));
    assert_eq!((corners[1].x, corners[2].x, corners[2].y), (1.25, 0.75 + 0.625, 1.5));
    assert_eq!(lattice.index_of(7), None);
}

#[test]
fn divisions_that_eight_characters_round_end_where_the_panel_ends() {
    let of = |ends: &str| {
        let cards = format!("CAERO1,1,1,0,,3,21,,1\n,0.,0.,0.,1.,0.,1.,0.,1.\nAEFACT,21,{ends}\n");
        Lattice::from_bulk(&deck(&cards)).unwrap_or_else(|error| panic!("{error}"))
    };
    assert_eq!(of("0.,.5,.9999999"), of("0.,.5,1."));
    assert_eq!(of("1.-7,.5,1."), of("0.,.5,1."));
    // A list of a part makes the boxes of that part, and it is said.
    let cards = |ends: &str| format!("CAERO1,1,1,0,,3,21,,1\n,0.,0.,0.,1.,0.,1.,0.,1.\nAEFACT,21,{ends}\n");
    let inner = of("0.,.25,.5");
    assert_eq!(inner.boxes[..], of("0.,.25,.5,1.").boxes[..6]);
    assert!(deck(&cards("0.,.25,.5")).division_remark().is_some_and(|said| said.contains("CAERO1 1 ")));
    assert_eq!(deck(&cards("0.,.25,.9999999")).division_remark(), None);
}

#[test]
fn bad_panels_are_refused_at_their_card() {
    let refusal = |cards: &str| Lattice::from_bulk(&deck(cards)).unwrap_err().to_string();
    let collision = refusal(
        "CAERO1,1,1,0,2,3,,,1\n,0.,0.,0.,1.,0.,1.,0.,1.\nCAERO1,6,1,0,2,3,,,1\n,3.,0.,0.,1.,3.,1.,0.,1.\n",
    );
    assert!(collision.contains("wing.bdf:4") && collision.contains("collide with CAERO1 6"), "{collision}");
    let missing = refusal("CAERO1,1,1,0,,3,99,,1\n,0.,0.,0.,1.,0.,1.,0.,1.\n");
    assert!(missing.contains("AEFACT 99"), "{missing}");
    let falling = refusal("CAERO1,1,1,0,,3,21,,1\n,0.,0.,0.,1.,0.,1.,0.,1.\nAEFACT,21,0.,.7,.5,1.\n");
    assert!(falling.contains("wing.bdf:4") && falling.contains("rise between 0.0 and 1.0"), "{falling}");
    for ends in ["0.,.5,1.1", "-.1,.5,1.", "0.,1.,1.", "1."] {
        for panel in ["CAERO1,1,1,0,,3,21,,1", "CAERO1,1,1,0,3,,,21,1"] {
            let open = refusal(&format!("{panel}\n,0.,0.,0.,1.,0.,1.,0.,1.\nAEFACT,21,{ends}\n"));
            assert!(open.contains("AEFACT 21 do not rise between 0.0 and 1.0"), "{ends}: {open}");
        }
    }
    let flat = refusal("CAERO1,1,1,0,2,3,,,1\n,0.,0.,0.,1.,1.,0.,0.,1.\n");
    assert!(flat.contains("no area"), "{flat}");
    let huge = refusal("CAERO1,1,1,0,5000,5000,,,1\n,0.,0.,0.,1.,0.,1.,0.,1.\n");
    assert!(huge.contains("25000000 boxes, and 50000 are the most"), "{huge}");
}

/// Nastran's remark on the downwash of AESURF boxes: the cosine of the hinge line's sweep, as needed to reproduce
/// the divergence pressures of the BAH wing. Hinges here are swept by 30 deg (in the plane) and not at all.
#[test]
fn a_swept_hinge_turns_boxes_by_the_cosine_of_its_sweep() {
    let cards = format!(
        "{WING}AESURF,5,AILERON,51,61\nAELIST,61,1002,1004\nCORD2R,51,0,0.,0.,0.,0.,0.,1.\n,.8660254,-.5,0.\n\
         AESURF,6,ELEV,52,62\nAELIST,62,3,THRU,6\nCORD2R,52,0,0.,0.,0.,0.,0.,1.\n,1.,0.,0.\n"
    );
    let bulk = deck(&cards);
    let lattice = Lattice::from_bulk(&bulk).unwrap();
    let controls = ControlSurface::all_from_bulk(&bulk, &lattice).unwrap();
    assert_eq!((controls[0].name.as_str(), controls[0].boxes.as_slice()), ("AILERON", [7, 9].as_slice()));
    assert!(controls[0].slope.iter().all(|slope| (slope - 30.0_f64.to_radians().cos()).abs() < 1e-7));
    assert_eq!(controls[1].slope, [1.0; 4]);
    let column = controls[1].column(lattice.len());
    assert_eq!(column, [0.0, 0.0, 1.0, 1.0, 1.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]);
}

/// Turned at 1 rad/s about its hinge, a three-quarter point at x aft of it moves down by x (cos of the sweep, for x across the
/// hinge); EFF is what share of a deflection the flow sees (Nastran's quick reference guide, AESURF).
#[test]
fn effectiveness_takes_its_share_of_incidence_and_of_the_speed_of_deflection() {
    let surfaces = |eff: &str| {
        let cards = format!(
            "{WING}AESURF,6,ELEV,52,62,,,{eff}\nAELIST,62,3,THRU,6\nCORD2R,52,0,2.5,0.,0.,2.5,0.,1.\n,3.5,0.,0.\n"
        );
        let bulk = deck(&cards);
        let lattice = Lattice::from_bulk(&bulk).unwrap();
        let control = ControlSurface::all_from_bulk(&bulk, &lattice).unwrap().remove(0);
        (control, lattice)
    };
    for (eff, share) in [("", 1.0), (".6", 0.6), ("-.25", -0.25)] {
        let (control, lattice) = surfaces(eff);
        assert_eq!(control.slope, [share; 4], "EFF {eff}");
        for (lever_m, place) in control.lever_m.iter().zip(&control.boxes) {
            let aft_m = lattice.boxes[*place].three_quarter_point().x - 2.5;
            assert!((lever_m - share * aft_m).abs() < 1e-12, "EFF {eff}: {lever_m} at {aft_m} m");
        }
    }
}

#[test]
fn control_surfaces_without_boxes_or_lists_are_refused() {
    let refusal = |cards: &str| {
        let bulk = deck(&format!("{WING}{cards}"));
        ControlSurface::all_from_bulk(&bulk, &Lattice::from_bulk(&bulk).unwrap()).unwrap_err().to_string()
    };
    assert!(refusal("AESURF,5,AILERON,0,61\n").contains("AELIST 61"));
    assert!(refusal("AESURF,5,AILERON,0,61\nAELIST,61,1002,77\n").contains("box 77"));
    assert!(refusal("AESURF,5,AILERON,9,61\nAELIST,61,1002\n").contains('9'));
}

#[test]
fn camber_comes_from_w2gj_in_the_order_of_boxes() {
    let mut bulk = deck(WING);
    let lattice = Lattice::from_bulk(&bulk).unwrap();
    assert_eq!(camber_and_twist(&bulk, &lattice).unwrap(), vec![0.0; 12]);
    let values: Vec<f64> = (0..12).map(|i| f64::from(i) * 0.01).collect();
    bulk.matrices.insert("W2GJ".to_owned(), nastran::Dmi::column_vector("W2GJ", values.clone()));
    assert_eq!(camber_and_twist(&bulk, &lattice).unwrap(), values);
    bulk.matrices.insert("W2GJ".to_owned(), nastran::Dmi::column_vector("W2GJ", vec![0.0; 3]));
    assert!(camber_and_twist(&bulk, &lattice).unwrap_err().message.contains("3 rows for 12 boxes"));
}
