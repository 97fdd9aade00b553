//! Cards that a deck gets beside those of the wing: sets of sets, references, splines and their systems, by hand.

use super::*;
use nalgebra::Vector3;
use nastran::{CoordDefinition, SplineKind as Card, parse_deck};

fn deck(text: &str) -> BulkData {
    parse_deck("cards.bdf", text).expect("cards")
}

fn clamped(sets: &[u32]) -> BulkData {
    let cards: Vec<String> = sets.iter().map(|set| format!("SPC1,{set},123,1")).collect();
    deck(&format!("GRID,1,,0.,0.,0.\nGRID,2,,0.,1.,0.\n{}\n", cards.join("\n")))
}

#[test]
fn several_sets_of_clamps_become_one_union_with_its_number_above_theirs() {
    assert_eq!(selected(&clamp_sets(&clamped(&[]))), None);
    assert_eq!(selected(&clamp_sets(&clamped(&[4]))), Some(4));
    assert_eq!(selected(&clamp_sets(&clamped(&[4, 9, 7]))), Some(10));
    assert_eq!(unions(&clamped(&[4])), "");
    assert_eq!(unions(&clamped(&[9, 4])), "SPCADD        10       4       9\n");
    // Seven on the first line, eight on each other one.
    let sets: Vec<u32> = (101..=117).collect();
    let text = unions(&clamped(&sets));
    let lines: Vec<&str> = text.lines().collect();
    assert_eq!(lines.len(), 3);
    assert!(lines[0].starts_with("SPCADD       118     101     102") && lines[0].len() == 72, "{text}");
    assert!(lines[1].starts_with("+            108     109") && lines[1].len() == 72, "{text}");
    assert_eq!(lines[2], "+            116     117");
    let equations = deck("GRID,1,,0.,0.,0.\nGRID,2,,0.,1.,0.\nMPC,5,1,3,1.,2,3,-1.\nMPC,6,1,2,1.,2,2,-1.\n");
    assert_eq!(unions(&equations), "MPCADD         7       5       6\n");
    assert_eq!(equation_sets(&equations).into_iter().collect::<Vec<_>>(), [5, 6]);
}

/// A wing's file without checks.
fn file(name: &str, rest: &str) -> WingFile {
    let text = format!(
        "Wing(name: {name:?}, balance: (x_m: 0.3, y_m: 0.1, z_m: -0.2), \
         correction: (chord_strips: 1, span_order: 1), {rest})"
    );
    nastran::ron_file::parse("wing.ron", &text).expect("a wing's file")
}

#[test]
fn the_case_control_names_what_applies_and_keeps_to_plain_titles() {
    let wing = file("a $ig wing with an é", PLAIN);
    let text = control(&wing, &clamped(&[4, 9]), 12);
    assert!(text.contains("\nTITLE = a  ig wing with an  \n"), "{text}");
    assert!(text.contains("\nSUBTITLE = 12 NORMAL MODES\n") && text.contains("\nMETHOD = 1\n"), "{text}");
    assert!(text.contains("\nSPC = 10\n") && !text.contains("MPC"), "{text}");
    let equations = deck("GRID,1,,0.,0.,0.\nGRID,2,,0.,1.,0.\nMPC,5,1,3,1.,2,3,-1.\n");
    let text = control(&wing, &equations, 1);
    assert!(text.contains("\nMPC = 5\n") && !text.contains("SPC"), "{text}");
    let long = control(&file(&"x".repeat(80), PLAIN), &equations, 1);
    assert!(long.contains(&format!("\nTITLE = {}\n", "x".repeat(60))), "{long}");
}

/// Half span 2 m, chord 0.6 to 0.4 m, no structure.
const PLAIN: &str = "source: Parametric((semispan_m: 2.0, root_chord_m: 0.6, tip_chord_m: 0.4, \
    quarter_chord_sweep_deg: 0.0, boxes: (chordwise: 2, spanwise: 3)))";

fn system(bulk: &BulkData, id: u32) -> [Vector3<f64>; 3] {
    let CoordDefinition::Points { rid, a, b, c } = bulk.coords[&id].definition.clone() else {
        panic!("points")
    };
    assert_eq!(rid, 0);
    [a.coords, b - a, c - a]
}

#[test]
fn references_of_a_half_model_are_its_area_and_the_whole_span() {
    let planes = [
        ("", 1, "4.00000", -0.0),
        (", root_plane: Symmetric(-0.25)", 1, "4.00000", -0.25),
        (", root_plane: None", 0, "2.00000", 0.1),
    ];
    for (plane, symmetry, span, y) in planes {
        let wing = file("plain", &format!("{PLAIN}{plane}"));
        let mut bulk = wing.bulk(Mount::Tunnel).expect("cards");
        let text = aerodynamics::add(&mut bulk, &wing).expect("boxes");
        assert_eq!(
            text,
            format!("AEROS,1,1,0.50000,{span},1.00000,{symmetry}\nAERO,1,,0.50000,1.22500,{symmetry}\n")
        );
        let [origin, z, x] = system(&bulk, 1);
        assert!((origin - Vector3::new(0.3, y, -0.2)).norm() < 1e-12, "{origin}");
        assert!((z - Vector3::z()).norm() < 1e-12 && (x - Vector3::x()).norm() < 1e-12);
        assert!(bulk.splines.is_empty());
    }
    // A fairing inboard is part of the boxes and of no reference; the plane is at its inner edge.
    let with = PLAIN.replace("boxes:", "fairing: (strips: 2, width_m: 0.5), boxes:");
    let wing = file("faired", &with);
    let mut bulk = wing.bulk(Mount::Tunnel).expect("cards");
    let text = aerodynamics::add(&mut bulk, &wing).expect("boxes");
    assert!(text.starts_with("AEROS,1,1,0.50000,4.00000,1.00000,1\n"), "{text}");
    assert!((system(&bulk, 1)[0].y + 0.5).abs() < 1e-12);
    assert_eq!(aerodynamics::add(&mut BulkData::default(), &wing).expect("nothing"), "");
    // Longer numbers keep to eight characters.
    let large = file("large", &PLAIN.replace("semispan_m: 2.0", "semispan_m: 6666.0"));
    let text = aerodynamics::add(&mut large.bulk(Mount::Tunnel).expect("cards"), &large).expect("boxes");
    assert!(text.contains(",0.50000,13332.00,3333.000,1\n"), "{text}");
}

/// A deck with grids at places, a panel of 2 by 2 boxes, and cards.
fn panel_on(grids: &[[f64; 3]], more: &str) -> BulkData {
    let cards: Vec<String> =
        (1..).zip(grids).map(|(id, [x, y, z])| format!("GRID,{id},,{x:.4},{y:.4},{z:.4}")).collect();
    let mut bulk = deck(&format!("{}\nPAERO1,1\n{more}", cards.join("\n")));
    let lattice = file("plain", PLAIN).bulk(Mount::Tunnel).expect("cards");
    bulk.panels.clone_from(&lattice.panels);
    bulk.panel_properties.clone_from(&lattice.panel_properties);
    bulk
}

#[test]
fn boxes_are_splined_to_a_line_of_grids_as_a_beam_and_to_others_as_a_plate() {
    let on_deck = |spline: &str, set: &str| {
        file("deck", &format!("spline: {spline}, source: Deck((file: \"wing.bdf\"{set}))"))
    };
    let line = [[0.2, 0.0, 0.0], [0.4, 1.0, 0.0], [0.6, 2.0, 0.0]];
    // Off the line by 1e-3 of its length of 2.0396 m, and a little less or more.
    let bent = |off: f64| {
        let mut bent = line;
        bent[1][2] = off;
        bent
    };
    let far = [[0.2, 0.0, 0.0], [0.8, 1.0, 0.0], [0.6, 2.0, 0.0]];
    for (what, spline, grids, is_beam) in [
        ("a line", "NearestNode", line, true),
        ("almost a line", "NearestNode", bent(0.0020), true),
        ("hardly a line", "NearestNode", bent(0.0021), false),
        ("a surface", "NearestNode", far, false),
        ("an axis that bends", "Beam", far, true),
    ] {
        let wing = on_deck(spline, "");
        let mut bulk = panel_on(&grids, "");
        aerodynamics::add(&mut bulk, &wing).expect("splines");
        assert_eq!(bulk.splines.len(), 1);
        let card = bulk.splines.values().next().expect("a spline");
        assert!(card.id == 100_001 && card.panel == 100_001 && card.boxes == (100_001, 100_006), "{card:?}");
        assert_eq!(bulk.sets[&card.set].ids, [1, 2, 3]);
        match card.kind {
            Card::Beam { system: id, torsional_ratio, .. } if is_beam => {
                assert_eq!(torsional_ratio, 1.0);
                let [origin, z, x] = system(&bulk, id);
                // y along the grids, x in the plane of y and the stream.
                let along = Vector3::new(0.4, 2.0, 0.0).normalize();
                assert!((origin - Vector3::new(0.2, 0.0, 0.0)).norm() < 1e-12, "{what}");
                assert!((z - Vector3::z()).norm() < 1e-9 && (z.cross(&x) - along).norm() < 1e-9, "{what}");
            }
            Card::Plate if !is_beam => {}
            _ => panic!("{what}: {card:?}"),
        }
    }
    // A set that has these grids already is used; a new one has the next number.
    let wing = on_deck("Beam", ", spline_set: 7");
    let mut bulk = panel_on(&line, "SET1,7,1,3\nSET1,9,1,3\nSET1,12,2\n");
    aerodynamics::add(&mut bulk, &wing).expect("splines");
    assert!(bulk.splines[&100_001].set == 7 && bulk.sets.len() == 3);
    let mut bulk = panel_on(&line, "SET1,12,2\n");
    aerodynamics::add(&mut bulk, &on_deck("Beam", "")).expect("splines");
    assert!(bulk.splines[&100_001].set == 13 && bulk.sets.len() == 2);
    let mut bulk = panel_on(&line, "SET1,7,1,5\n");
    let refused = aerodynamics::add(&mut bulk, &wing).expect_err("no grid 5").to_string();
    assert!(refused.contains("grid 5"), "{refused}");
    // One grid has no line: a plate.
    let mut bulk = panel_on(&line[..1], "");
    aerodynamics::add(&mut bulk, &on_deck("Beam", "")).expect("splines");
    assert!(matches!(bulk.splines[&100_001].kind, Card::Plate));
}
