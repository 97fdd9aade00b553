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
    // A component that is not there is left out, as Nastran does (its warning 7701), and named.
    let bulk = deck("MONPNT1,TOTAL   ,label\n,123456,ALL,0,15.,0.,0.\n", &[]);
    assert_eq!(TrimDeck::new(&bulk, 0.9).unwrap().skipped_monitors, ["TOTAL"]);
}

#[test]
fn stations_of_one_name_are_kept_one_after_the_other_and_lists_of_components_add_up() {
    let more = "AECOMP,WING,CAERO,1100\nAECOMP,CANARD,CAERO,1000\nAECOMPL,BOTH,WING,CANARD\n\
                MONPNT1,SAME    ,wing\n,123456,WING,0,15.,0.,0.\nMONPNT1,SAME    ,canard\n,123456,CANARD,0,15.,0.,0.\n\
                MONPNT1,ALL     ,list\n,123456,BOTH,0,15.,0.,0.\n";
    let bulk = deck(more, &[]);
    assert_eq!(bulk.station_names(), ["SAME", "SAME (2)", "ALL"]);
    let trimmed = TrimDeck::new(&bulk, 0.9).unwrap().trim_card(&bulk.trims[&1]).unwrap();
    let loads = |name: &str| trimmed.monitors[name];
    near(loads("SAME (2)")[2], trimmed.lift[..8].iter().sum(), 1e-12);
    for component in 0..6 {
        let sum = loads("SAME")[component] + loads("SAME (2)")[component];
        assert!(
            (loads("ALL")[component] - sum).abs() <= 1e-9 * loads("ALL")[2].abs(),
            "component {component}"
        );
    }
}

#[test]
fn where_both_forms_diverge_the_trim_is_refused_and_just_below_it_the_lift_slope_has_grown_without_bound() {
    let bulk = deck("", &[]);
    let tail = [("SUPORT,90,", "SUPORT,100,"), ("1246,90", "1246,100"), ("97,98,99,100", "97,98,99,90")];
    let moved = TrimDeck::new(&deck("", &tail), 0.9).unwrap();
    let deck = TrimDeck::new(&bulk, 0.9).unwrap();
    let first = deck.divergence_pressures()[0];
    let slope = |q: f64| deck.derivatives(q, fullaircraft::Elastic::Restrained)["ANGLEA"][2].abs();
    // near a simple pole the slope goes with 1/(q_D - q)
    near(slope(first * (1.0 - 1e-4)) / slope(first * (1.0 - 1e-3)), 10.0, 0.01);
    let error = deck.trim(first * 1.01, &bulk.trims[&1].fixed).unwrap_err();
    assert!(error.to_string().contains("diverge"), "{error}");
    // The free aircraft does not know where it was held.
    assert!((moved.divergence_pressures()[0] / first - 1.0).abs() > 0.01);
    near(moved.free_divergence().unwrap().unwrap(), deck.free_divergence().unwrap().unwrap(), 1e-6);
}

#[test]
fn an_aircraft_that_diverges_only_as_it_is_held_is_trimmed() {
    // Held behind its air on a spring that is soft in pitch, at a grid of no mass, it diverges; in flight the spring carries nothing.
    let soft = "GRID,500,,30.,0.,0.\nCBUSH,500,500,100,500,,,,0\nPBUSH,500,K,1.+9,1.+9,1.+9,1.+9,1.+4,1.+9\nSPC1,1,246,500\n";
    let plain = deck("", &[]);
    let trim = |bulk: &BulkData| {
        let deck = TrimDeck::new(bulk, 0.9).unwrap();
        (deck.divergence_pressures()[0], deck.trim_card(&plain.trims[&1]).unwrap())
    };
    let (held, flown) = trim(&deck(soft, &[("SUPORT,90,", "SUPORT,500,")]));
    let (_, expected) = trim(&plain);
    assert!(held < plain.trims[&1].q, "{held}");
    near(flown.values["ELEV"], expected.values["ELEV"], 1e-5);
    near(flown.mean_angle_of_attack_rad.unwrap(), expected.mean_angle_of_attack_rad.unwrap(), 1e-5);
    near(flown.lift.iter().sum(), 8000.0, 2e-6);
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
fn a_deck_with_other_splines_is_refused_in_words() {
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

/// The deck with all that stands in the basic system turned and shifted, and the stream with it.
fn turned(mut bulk: BulkData) -> BulkData {
    let turn = nalgebra::Rotation3::new(nalgebra::Vector3::new(0.4, -0.8, 2.5));
    let at =
        |v: nalgebra::Vector3<f64>| nalgebra::Point3::from(nalgebra::Vector3::new(7.0, -3.0, 2.0) + turn * v);
    let (a, b, c) = (at(nalgebra::Vector3::zeros()), at(nalgebra::Vector3::z()), at(nalgebra::Vector3::x()));
    let other = |id: u32| if id == 0 { 900 } else { id };
    for coord in bulk.coords.values_mut() {
        if let nastran::CoordDefinition::Points { rid, .. } = &mut coord.definition {
            *rid = other(*rid);
        }
    }
    let span = nastran::Span::generated("the test");
    let definition = nastran::CoordDefinition::Points { rid: 0, a, b, c };
    bulk.coords
        .insert(900, nastran::Coord { id: 900, kind: nastran::CoordKind::Rectangular, definition, span });
    bulk.grids.values_mut().for_each(|grid| (grid.cp, grid.cd) = (other(grid.cp), other(grid.cd)));
    bulk.panels.values_mut().for_each(|panel| panel.cp = other(panel.cp));
    bulk.monitors.iter_mut().for_each(|card| (card.cp, card.cd) = (other(card.cp), other(card.cd)));
    bulk
}

#[test]
fn a_deck_turned_with_its_stream_has_the_same_trim_loads_and_derivatives() {
    let more = "AECOMP,WING,CAERO,1100\nMONPNT1,WING    ,wing\n,123456,WING,0,15.,0.,0.\n\
                SET1,77,110,111,112,120,121,122\nMONPNT3,NET     ,net\n,123456,77,,0,15.,0.,0.\n";
    let (straight, turned) = (deck(more, &[]), turned(deck(more, &[])));
    let [one, other] = [&straight, &turned].map(|bulk| TrimDeck::new(bulk, 0.9).expect("a deck"));
    let [a, b] = [&one, &other].map(|deck| deck.trim_card(&straight.trims[&2]).expect("a trim"));
    for (name, value) in &a.values {
        assert!((value - b.values[name]).abs() < 1e-9, "{name}: {value} {}", b.values[name]);
    }
    for name in ["WING", "NET"] {
        let size = a.monitors[name].iter().map(|load| load.abs()).fold(0.0, f64::max);
        for (x, y) in a.monitors[name].iter().zip(&b.monitors[name]) {
            assert!((x - y).abs() < 1e-8 * size, "{name}: {x} {y}");
        }
    }
    for elastic in [fullaircraft::Elastic::Restrained, fullaircraft::Elastic::Unrestrained] {
        let [x, y] = [&one, &other].map(|deck| deck.derivatives(1200.0, elastic));
        for (name, coefficients) in &x {
            for (p, q) in coefficients.iter().zip(&y[name]) {
                assert!((p - q).abs() < 1e-8, "{name}: {p} {q}");
            }
        }
    }
    // with the stream along the basic x it is another aircraft
    let mut crosswise = turned;
    crosswise.aero_reference.as_mut().expect("AEROS").acsid = 0;
    let found =
        TrimDeck::new(&crosswise, 0.9).map(|deck| deck.derivatives(40.0, fullaircraft::Elastic::Rigid));
    let slope = one.derivatives(40.0, fullaircraft::Elastic::Rigid)["ANGLEA"][2];
    assert!(found.is_err() || found.is_ok_and(|all| (all["ANGLEA"][2] / slope - 1.0).abs() > 0.1));
}

#[test]
fn the_angle_of_attack_of_the_mean_axes_is_that_of_no_grid_in_particular() {
    let at = |grid: &str| {
        let bulk = deck("", &[("SUPORT,90,35", &format!("SUPORT,{grid},35"))]);
        TrimDeck::new(&bulk, 0.9).unwrap().trim_card(&bulk.trims[&2]).unwrap()
    };
    let [one, other] = ["90", "98"].map(at);
    let apart = one.values["ANGLEA"] - other.values["ANGLEA"];
    assert!(apart.abs() > 1e-4, "the fuselage bends between the two: {apart}");
    near(one.values["ELEV"], other.values["ELEV"], 1e-9);
    let [a, b] = [&one, &other].map(|trimmed| trimmed.mean_angle_of_attack_rad.expect("a SUPORT in pitch"));
    assert!((a - b).abs() < 1e-9, "{a} {b}, {apart}");
    assert!((a - one.values["ANGLEA"]).abs() > 5e-6, "{a} {}", one.values["ANGLEA"]);
    // A structure that hardly bends has its grids' angle.
    let mut stiff = deck("", &[]);
    stiff
        .materials
        .values_mut()
        .for_each(|material| (material.e, material.g) = (1e6 * material.e, 1e6 * material.g));
    let trimmed = TrimDeck::new(&stiff, 0.9).unwrap().trim_card(&stiff.trims[&2]).unwrap();
    near(trimmed.mean_angle_of_attack_rad.expect("an angle"), trimmed.values["ANGLEA"], 1e-4);
}

#[test]
fn components_of_several_grids_support_an_aircraft_as_those_of_one_do() {
    // the half model as a whole one: all six motions free, held at one grid or at two
    let at = |support: &str| {
        let change = [
            ("SPC = 1\n", ""),
            ("SPC1,1,1246,90\n", ""),
            ("SPC1,1,246,97,98,99,100\n", ""),
            ("SUPORT,90,35\n", support),
            (
                "AESTAT,501,ANGLEA\n",
                "AESTAT,501,ANGLEA\nAESTAT,605,URDD1\nAESTAT,606,URDD2\nAESTAT,607,URDD4\nAESTAT,608,URDD6\n",
            ),
        ];
        let mut bulk = deck("", &change);
        bulk.aero_reference.as_mut().expect("AEROS").symmetry = 0;
        let bulk = bulk.in_subcase(&bulk.subcases[0]).expect("a subcase");
        TrimDeck::new(&bulk, 0.9).and_then(|deck| deck.trim_card(&bulk.trims[&1]))
    };
    let [one, two] =
        ["SUPORT,90,123456\n", "SUPORT,90,1234\nSUPORT,99,23\n"].map(|support| at(support).expect("a trim"));
    for name in ["URDD1", "URDD2", "URDD4", "URDD6", "ELEV"] {
        let scale = one.values[name].abs().max(1e-3);
        assert!((one.values[name] - two.values[name]).abs() < 1e-7 * scale, "{name}: {one:?} {two:?}");
    }
    let [a, b] = [&one, &two].map(|trimmed| trimmed.mean_angle_of_attack_rad.expect("pitch"));
    near(a, b, 1e-7);
    let error = at("SUPORT,90,1234\nSUPORT,99,45\n").expect_err("yaw is free").to_string();
    assert!(error.contains("do not hold a rigid body"), "{error}");
}

#[test]
fn a_clamp_beside_the_supported_grid_is_left_where_it_is() {
    // Held along x ten feet below, pitch takes the masses along: to the free aircraft that is 10^2 times its mass of inertia in pitch, and else nothing.
    let arm = "GRID,500,,15.,0.,-10.\nCBAR,500,500,90,500,1.,0.,0.\nPBAR,500,1,100.,1.+4,1.+4,1.+4\n\
        SPC1,1,1246,500\n";
    let below = deck(arm, &[("SPC1,1,1246,90", "SPC1,1,246,90")]);
    // What is in balance is the moment with that of the force along x which the clamp takes.
    let balanced = TrimDeck::new(&below, 0.9).unwrap().grids.balanced;
    let pitch = balanced.iter().find(|one| one.load == 4).expect("pitch is supported");
    let off = pitch.shares.iter().zip([10.0, 0.0, 0.0, 0.0, 1.0, 0.0]).map(|(ours, law)| (ours - law).abs());
    assert!(off.fold(0.0, f64::max) < 1e-9 && pitch.about.x == 15.0, "{pitch:?}");
    let heavy = deck("CONM2,500,90,0,0.,,,,,+\n+,0.,0.,800000.\n", &[]);
    let derivatives = |bulk: &BulkData| {
        TrimDeck::new(bulk, 0.9).unwrap().derivatives(40.0, fullaircraft::Elastic::Unrestrained)["ANGLEA"]
    };
    let [below, heavy, plain] = [&below, &heavy, &deck("", &[])].map(derivatives);
    // But for the stretch of the fuselage, which the masses pull along.
    near(below[2], heavy[2], 1e-5);
    near(below[4], heavy[4], 1e-5);
    assert!((below[2] / plain[2] - 1.0).abs() > 2e-4, "{} is not {}", below[2], plain[2]);
}

/// MSC.Nastran Quick Reference Guide, TRIM: AEQR = 0 asks for a rigid trim. Forces balance by the rigid derivatives alone.
#[test]
fn a_rigid_trim_balances_by_rigid_derivatives() {
    let bulk = deck("", &[]);
    let aircraft = TrimDeck::new(&bulk, 0.9).unwrap();
    let mut card = bulk.trims[&1].clone();
    let elastic = aircraft.trim_card(&card).unwrap();
    card.elastic_share = 0.0;
    let rigid = aircraft.trim_card(&card).unwrap();
    let sum = |at: usize| -> f64 {
        let all = aircraft.derivatives(card.q, fullaircraft::Elastic::Rigid);
        all.iter().map(|(name, coefficients)| coefficients[at] * rigid.values[name]).sum()
    };
    // level flight of half the aircraft, 8000 lbf; z of the reference axes is down, and so is that of its coefficients
    let aeros = aircraft.aeros();
    near(-sum(2) * card.q * aeros.area, 8000.0, 1e-6);
    assert!((rigid.values["ANGLEA"] - elastic.values["ANGLEA"]).abs() > 1e-4, "the wing bends");
    card.elastic_share = 1e-9;
    near(aircraft.trim_card(&card).unwrap().values["ELEV"], rigid.values["ELEV"], 1e-6);
    card.elastic_share = 1.0;
    assert_eq!(aircraft.trim_card(&card).unwrap().values, elastic.values);
}

/// Nastran's mass is that of the free motions: a mass on a grid that is held, whoever holds it, is not accelerated.
#[test]
fn a_mass_on_a_held_grid_does_not_fly() {
    let trimmed = |more: &str| {
        let bulk = deck(more, &[]);
        TrimDeck::new(&bulk, 0.9).unwrap().trim_card(&bulk.trims[&1]).unwrap().values
    };
    let plain = trimmed("");
    for held in ["GRID,900,,10.,0.,0.,,123456\n", "GRID,900,,10.,0.,0.\nSPC1,1,123456,900\n"] {
        let with = trimmed(&format!("{held}CONM2,9000,900,,100.\n"));
        for label in ["ANGLEA", "ELEV"] {
            near(with[label], plain[label], 1e-9);
        }
    }
    let flying = trimmed("GRID,900,,10.,0.,0.\nRBAR,9001,90,900,123456\nCONM2,9000,900,,100.\n");
    assert!(
        (flying["ANGLEA"] - plain["ANGLEA"]).abs() > 1e-3 * plain["ANGLEA"].abs(),
        "a mass that flies counts"
    );
}
