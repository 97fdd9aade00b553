//! Every card that is read: its fields, Nastran's defaults, and what is refused.

use nastran::{BulkData, CoordDefinition, Divisions, Orientation, parse_deck};

fn parse(text: &str) -> BulkData {
    parse_deck("t.bdf", text).unwrap_or_else(|error| panic!("{error}"))
}

fn error(text: &str) -> String {
    let error =
        parse_deck("t.bdf", text).and_then(|deck| deck.refuse_unread_air()).expect_err("must be refused");
    format!("{}: {}", error.span.as_ref().expect("errors of decks have a place"), error.message)
}

#[test]
fn coordinate_systems() {
    let deck = parse("CORD2R,5,,1.,2.,3.,1.,2.,4.\n,2.,2.,3.\nCORD1R,6,1,2,3,7,4,5,6\n");
    let expected = CoordDefinition::Points {
        rid: 0,
        a: [1.0, 2.0, 3.0].into(),
        b: [1.0, 2.0, 4.0].into(),
        c: [2.0, 2.0, 3.0].into(),
    };
    assert_eq!(deck.coords[&5].definition, expected);
    assert_eq!(deck.coords[&6].definition, CoordDefinition::Grids([1, 2, 3]));
    assert_eq!(deck.coords[&7].definition, CoordDefinition::Grids([4, 5, 6]));
}

#[test]
fn bars_and_beams() {
    let deck = parse("CBAR,10,,1,2,0.,0.,1.\nCBEAM,11,4,1,2,3,,,GGG\n,45,,0.,.1,0.,.2\n");
    let bar = &deck.beams[&10];
    assert_eq!(
        (bar.property, bar.grids, bar.is_beam),
        (10, [1, 2], false),
        "the property is by default the element's number"
    );
    assert_eq!(bar.orientation, Orientation::Vector([0.0, 0.0, 1.0].into()));
    let beam = &deck.beams[&11];
    assert_eq!((beam.property, beam.is_beam), (4, true));
    assert_eq!(beam.orientation, Orientation::Grid(3));
    assert_eq!(beam.pins, [vec![4, 5], vec![]]);
    assert_eq!(beam.offsets.map(<[f64; 3]>::from), [[0.0, 0.1, 0.0], [0.2, 0.0, 0.0]]);
    assert_eq!(
        error("CBAR,10,1,1,2,0.,0.,1.,EGG\n"),
        "t.bdf:1:24: `EGG` in field OFFT of CBAR is not G or B and twice G or O, such as GGG or BOO"
    );
    assert_eq!(
        error("CBAR,10,1,1,2\n"),
        "t.bdf:1:14: field X1 of CBAR is empty; expected an orientation vector or a grid"
    );
}

#[test]
fn pbar_puts_i12_and_shear_factors_on_its_third_line() {
    let deck = parse("PBAR,1,2,.1,.2,.3,.4,.5\n,1.,1.,1.,1.\n,.8,.9,.05\n");
    let property = &deck.beam_properties[&1];
    let station = property.stations[0];
    assert_eq!(
        (station.area, station.i1, station.i2, station.i12, station.j, station.nsm),
        (0.1, 0.2, 0.3, 0.05, 0.4, 0.5)
    );
    assert_eq!(property.shear_factors, [0.0; 2], "with I12 a bar has none");
    let straight = parse("PBAR,1,2,.1,.2,.3,.4,.5\n,1.,1.,1.,1.\n,.8,.9\n");
    assert_eq!(straight.beam_properties[&1].shear_factors, [0.8, 0.9]);
    assert_eq!(parse("PBAR,1,2,.1,.2,.3,.4\n").beam_properties[&1].shear_factors, [0.0, 0.0]);
}

#[test]
fn pbeam_fills_end_b_from_end_a_and_stations_from_both() {
    let deck = parse(concat!(
        "PBEAM,1,2,1.,2.,3.,.5,4.,.25\n",
        ",,,,,,,,\n+,YESA,1.,3.,4.,,,8.\n",
        "+,NO,.5,,2.5\n",
        "+,,,,,.1,,,\n+,.01,.02,,,.03,.04,.05,.06\n"
    ));
    let property = &deck.beam_properties[&1];
    let stations: Vec<[f64; 7]> =
        property.stations.iter().map(|s| [s.x_over_l, s.area, s.i1, s.i2, s.i12, s.j, s.nsm]).collect();
    assert_eq!(
        stations,
        [
            [0.0, 1.0, 2.0, 3.0, 0.5, 4.0, 0.25],
            [0.5, 2.0, 2.5, 3.0, 0.5, 6.0, 0.25],
            [1.0, 3.0, 4.0, 3.0, 0.5, 8.0, 0.25]
        ]
    );
    assert_eq!(property.shear_factors, [1.0, 1.0], "K1 and K2 of PBEAM are 1 by default");
    assert_eq!(property.nsi, [0.1, 0.1]);
    assert_eq!(property.nsm_offset, [[0.01, 0.02], [0.01, 0.02]]);
    assert_eq!(property.neutral_axis, [[0.03, 0.04], [0.05, 0.06]]);
}

#[test]
fn pbeam_of_one_line_is_uniform_and_stress_points_are_skipped() {
    let uniform = parse("PBEAM,1,2,1.,2.,3.\n");
    assert_eq!(uniform.beam_properties[&1].stations.len(), 2);
    assert_eq!(uniform.beam_properties[&1].stations[1].i2, 3.0);
    let points = parse("PBEAM,1,2,1.,2.,3.\n,9.,9.,9.,9.\n,YES,1.,5.\n,9.,9.,9.,9.\n,.0,.7\n");
    assert_eq!(points.beam_properties[&1].stations[1].area, 5.0);
    assert_eq!(points.beam_properties[&1].shear_factors, [0.0, 0.7]);
    assert_eq!(
        error("PBEAM,1,2,1.,2.,3.\n,NO,1.5\n"),
        "t.bdf:2:5: `1.5` in field X/XB of PBEAM is not above 0 and at most 1"
    );
    assert_eq!(error("PBEAM,1,2,1.\n,NO,.5\n,NO,.5\n"), "t.bdf:3:5: station 0.5 of PBEAM is given twice");
}

#[test]
fn mat1_derives_the_modulus_that_is_missing() {
    let deck = parse("MAT1,1,7.,,.4\nMAT1,2,7.,2.5\nMAT1,3,,2.5,.4,2700.\nMAT1,4,7.\n");
    assert_eq!(deck.materials[&1].g, 7.0 / 2.8);
    assert!((deck.materials[&2].nu - 0.4).abs() < 1e-15);
    assert_eq!((deck.materials[&3].e, deck.materials[&3].rho), (7.0, 2700.0));
    assert_eq!((deck.materials[&4].g, deck.materials[&4].nu), (0.0, 0.0));
    assert_eq!(
        error("MAT1,1\n"),
        "t.bdf:1:7: field E of MAT1 is empty; expected Young's modulus, or the shear modulus in field G"
    );
}

#[test]
fn masses_rigid_elements_and_constraints() {
    let deck =
        parse("CONM2,1,2,-1,3.,.1,.2,.3\n,1.,2.,3.,4.,5.,6.\nRBE2,5,1,123,2,3,1.-5\nSPC1,1,246,4,THRU,7\n");
    let mass = &deck.masses[&1];
    assert_eq!((mass.grid, mass.cid, mass.mass, mass.offset), (2, -1, 3.0, [0.1, 0.2, 0.3].into()));
    assert_eq!(mass.inertia, [1.0, 2.0, 3.0, 4.0, 5.0, 6.0]);
    assert_eq!(deck.rigid[&5].dependent, [2, 3], "a thermal expansion coefficient is no grid");
    assert_eq!((&deck.rigid[&5].components, deck.rigid[&5].independent), (&vec![1, 2, 3], 1));
    assert_eq!(deck.constraints[0].grids, [4, 5, 6, 7]);
    assert_eq!(
        error("SPC1,1,127,4\n"),
        "t.bdf:1:8: `127` in field C of SPC1 is not a combination of the digits 1 to 6"
    );
    assert_eq!(error("SPC1,1,12,7,THRU,4\n"), "t.bdf:1:18: 7 THRU 4 is not a range that can be meant");
    assert_eq!(
        error("SET1,1,THRU,4\n"),
        "t.bdf:1:8: `THRU` in field ID of SET1 is not a positive whole number"
    );
    assert_eq!(error("SET1,1\n"), "t.bdf:1:7: field ID of SET1 is empty; expected at least one number");
}

#[test]
fn panels_and_control_surfaces() {
    let deck = parse(concat!(
        "CAERO1,1001,1,,8,,,3,1\n,0.,0.,0.,.3,.1,1.8,0.,.15\nPAERO1,1\nAEFACT,3,0.,.5,1.\n",
        "AESURF,9,aileron,7,8\nAELIST,8,1001,THRU,1003,1010\nSET1,4,1,THRU,3,9\n"
    ));
    let panel = &deck.panels[&1001];
    assert_eq!((panel.span_divisions, panel.chord_divisions), (Divisions::Equal(8), Divisions::Aefact(3)));
    assert_eq!((panel.chord_1, panel.chord_4, panel.point_4), (0.3, 0.15, [0.1, 1.8, 0.0].into()));
    assert!(deck.panel_properties.contains_key(&1));
    assert_eq!(deck.factors[&3].values, [0.0, 0.5, 1.0]);
    assert_eq!((&*deck.surfaces[&9].label, &deck.surfaces[&9].parts), ("AILERON", &vec![(7, 8)]));
    assert_eq!(deck.surfaces[&9].effectiveness, 1.0);
    assert_eq!(deck.box_lists[&8].boxes, [1001, 1002, 1003, 1010]);
    assert_eq!(deck.sets[&4].ids, [1, 2, 3, 9]);
    assert_eq!(
        error("CAERO1,1001,1,,8,4,2\n"),
        "t.bdf:1:20: CAERO1 has both NSPAN and LSPAN; give one of them"
    );
    assert_eq!(
        error("CAERO1,1001,1,,8\n"),
        "t.bdf:1:17: field NCHORD of CAERO1 is empty; expected a number, here or an AEFACT in LCHORD"
    );
}

#[test]
fn monitoring_stations_keep_their_labels() {
    let deck = parse(concat!(
        "MONPNT1 WING    Right wing, root: bending and torsion\n        246     WINGCOMP        .075    .1      0.\n",
        "MONPNT3 ROOT    Root loads\n        123456  6               5       .5      0.      0.\n        2\n",
        "CORD2R,5,,0.,0.,0.,0.,0.,1.\n,1.,0.,0.\n"
    ));
    let [aero, structure] = &deck.monitors[..] else { panic!("two stations") };
    assert_eq!(aero.label, "Right wing, root: bending and torsion");
    assert_eq!(
        (&*aero.set, aero.xyz, aero.cd, aero.is_structural),
        ("WINGCOMP", [0.075, 0.1, 0.0].into(), 0, false)
    );
    assert_eq!((&*structure.name, &*structure.set, structure.cp, structure.cd), ("ROOT", "6", 5, 2));
    assert_eq!((structure.xyz, structure.is_structural), ([0.5, 0.0, 0.0].into(), true));
}

#[test]
fn elements_are_counted_by_the_name_of_their_card() {
    let deck = "GRID,1\nGRID,2,,1.\nCBAR,1,1,1,2,0.,0.,1.\nCBEAM,2,1,1,2,0.,0.,1.\nCBEAM,3,1,1,2,0.,0.,1.\n\
                CONM2,1,2,,1.\nRBE2,9,1,123456,2\n";
    let counts = parse(deck).element_counts();
    let expected = [("CBAR", 1), ("CBEAM", 2), ("CONM2", 1), ("RBE2", 1)];
    assert_eq!(counts.into_iter().collect::<Vec<_>>(), expected);
}

#[test]
fn unknown_cards_are_counted() {
    let deck = parse("CSEAM,1,2,3,4,5,6\nCSEAM,2,2,3,4,5,6\nPLOTEL,1,1,2\n");
    assert_eq!(deck.unread_cards().expect("two kinds"), "2 CSEAM, 1 PLOTEL");
}

#[test]
fn defaults_fill_blanks_wherever_they_stand_and_never_a_zero_that_is_written() {
    let given = "GRID,1,7,1.,2.,3.,8,345\nGRID,2,0,1.,2.,3.,0,0\nCBAR,1,5,1,2,0.,0.,1.\nCBEAM,2,6,1,2,0.,1.,0.\n\
                 CBAR,3,9,1,2,1.,0.,0.\n";
    let systems = "CORD2R,7,,0.,0.,0.,0.,0.,1.,\n,1.,0.,0.\nCORD2R,8,,0.,0.,0.,0.,0.,1.,\n,1.,0.,0.\n";
    let plain = parse(&(given.to_owned() + systems));
    let short = "GRID,1,,1.,2.,3.\nGRID,2,0,1.,2.,3.,0,0\nCBAR,1,,1,2\nCBEAM,2,,1,2\nCBAR,3,9,1,2,1.,0.,0.\n\
                 GRDSET,,7,,,,8,345\nBAROR,,5,,,0.,0.,1.\nBEAMOR,,6,,,0.,1.,0.\n";
    let filled = parse(&(short.to_owned() + systems));
    for id in [1, 2] {
        let (a, b) = (&filled.grids[&id], &plain.grids[&id]);
        assert_eq!((a.cp, a.cd, &a.ps), (b.cp, b.cd, &b.ps));
    }
    for id in [1, 2, 3] {
        let (a, b) = (&filled.beams[&id], &plain.beams[&id]);
        assert_eq!((a.property, &a.orientation), (b.property, &b.orientation));
    }
    assert_eq!((filled.grids[&1].cp, filled.beams[&1].property), (7, 5));
    let twice = parse_deck("t", "GRDSET,,,,,,,345\nGRDSET,,,,,,,34\n").unwrap_err();
    assert!(twice.to_string().contains("GRDSET is given twice"), "{twice}");
}

#[test]
fn elements_of_two_kinds_with_one_number_are_kept_and_said() {
    let grids = "GRID,1\nGRID,2,,1.\n";
    let bars = [1, 2, 3, 4, 5, 6].map(|id| format!("CBAR,{id},1,1,2,0.,0.,1.\nCROD,{id},2,1,2\n")).concat();
    let deck = parse(&format!("{grids}{bars}CROD,9,2,1,2\n"));
    assert_eq!((deck.beams.len(), deck.rods.len()), (6, 7));
    assert_eq!(
        deck.remarks(),
        [
            "elements of different kinds have one number, and each is kept: CBAR 1 and CROD 1, CBAR 2 and CROD 2, CBAR 3 and CROD 3, \
             CBAR 4 and CROD 4 and 2 more"
        ]
    );
    assert!(parse(&format!("{grids}CBAR,1,1,1,2,0.,0.,1.\nCROD,2,2,1,2\n")).remarks().is_empty());
    let twice = error(&format!("{grids}CROD,1,2,1,2\nCROD,1,2,1,2\n"));
    assert!(twice.contains("CROD 1 is given twice"), "{twice}");
}

#[test]
fn a_concentrated_mass_may_be_inertia_alone() {
    let deck = parse("CONM2    10001   1       0               0.      0.      0.\n+       4.\n");
    assert_eq!((deck.masses[&10001].mass, deck.masses[&10001].inertia[0]), (0.0, 4.0));
}

#[test]
fn a_grid_that_is_given_again_as_it_was_is_one_grid() {
    let again = "GRDSET,,,,,,,456\nGRID,1,,1.,2.,3.\nGRID,2\nGRID*,1,,1.,2.\n*,3.\n";
    let deck = parse_deck("t.bdf", again).unwrap();
    assert_eq!((deck.grids.len(), deck.grids[&1].ps.len()), (2, 3));
    let other = parse_deck("t.bdf", "GRID,1,,1.,2.,3.\nGRID,1,,1.,2.,3.,,4\n").unwrap_err().to_string();
    assert!(other.starts_with("t.bdf:2:6: GRID 1 is given twice"), "{other}");
}

#[test]
fn a_number_given_twice_is_refused_with_both_places() {
    assert_eq!(
        error("GRID,1\n$\nGRID,2\nGRID,1,,.5\n"),
        "t.bdf:4:6: GRID 1 is given twice; the number or name is taken since t.bdf:1:1"
    );
    assert_eq!(
        error("CBAR,1,1,1,2,0.,0.,1.\nCBEAM,1,1,1,2,0.,0.,1.\n"),
        "t.bdf:2:7: CBEAM 1 has the number of another element, CBAR 1 at t.bdf:1:1"
    );
}

#[test]
fn a_grid_in_an_undefined_coordinate_system_is_refused() {
    assert_eq!(
        error("GRID,1,3,0.,0.,0.\n"),
        "t.bdf:1:1: grid 1 refers to coordinate system 3, which is not defined"
    );
    let unread =
        parse_deck("t.bdf", "CORD3G,3,,0.,0.,0.,0.,0.,1.\n,1.,0.,0.\nGRID,1,,0.,0.,0.,3\n").unwrap_err();
    assert_eq!(
        unread.help.as_deref(),
        Some(
            "the deck has CORD3G cards, which are not read; use CORD1R, CORD1C, CORD1S, CORD2R, CORD2C or CORD2S"
        )
    );
}

#[test]
fn a_real_without_a_point_is_refused_with_advice() {
    let error = parse_deck("t.bdf", "GRID,1,,5,0.,0.\n").unwrap_err();
    assert_eq!(
        error.to_string(),
        "t.bdf:1:9: `5` in field X1 of GRID is not a real number (hint: write `5.` with a decimal point)"
    );
}
