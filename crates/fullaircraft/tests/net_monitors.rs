//! MONPNT3 of decks: net loads on grids, by their laws on HA144A.

use coupling::{DeckOptions, NastranDeck, WingFile};
use fullaircraft::TrimDeck;
use nastran::{BulkData, parse_deck};
use std::path::Path;

/// HA144A with the whole, the wing outboard of its root, and the rest as stations, the last two about the wing's grid 110.
fn ha144a() -> BulkData {
    let more = "SET1,81,90,97,98,99,100,110,111,+A\n+A,112,120,121,122\nSET1,82,110,111,112,120,121,122\n\
                SET1,83,90,97,98,99,100\n\
                MONPNT3,WHOLE   ,all\n,123456,81,,0,15.,0.,0.\nMONPNT3,OUTER   ,wing\n,123456,82,,0,27.11325,5.,0.\n\
                MONPNT3,INNER   ,rest\n,123456,83,,0,27.11325,5.,0.\nMONPNT3,GROUP   ,a group\n,123456,WING,,0,0.,0.,0.\n\
                AECOMP,ALL,CAERO,1000,1100\nMONPNT1,AIR     ,all boxes\n,123456,ALL,0,15.,0.,0.\n";
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/published/decks/ha144a_fsw.bdf");
    let mut text = std::fs::read_to_string(path).expect("the shipped deck");
    let at = text.find("ENDDATA").unwrap_or(text.len());
    text.insert_str(at, more);
    parse_deck("ha144a", &text).expect("cards that are right")
}

#[test]
fn net_loads_on_all_grids_of_a_trimmed_deck_are_in_balance_and_parts_add_up() {
    let bulk = ha144a();
    let deck = TrimDeck::new(&bulk, 0.9).unwrap();
    assert_eq!(deck.skipped_monitors, ["GROUP"], "a group is no SET1");
    for trim in bulk.trims.values() {
        let found = deck.trim_card(trim).unwrap().monitors;
        let [whole, outer, inner, air] = ["WHOLE", "OUTER", "INNER", "AIR"].map(|name| found[name]);
        // half of the aircraft weighs 8000 lbf; free are plunge and pitch
        assert!(whole[2].abs() < 1e-9 * 8000.0 && whole[4].abs() < 1e-9 * 8000.0 * 15.0, "{whole:?}");
        assert!((air[2] - 8000.0).abs() < 0.1, "the air carries the weight: {air:?}");
        // about grid 110: what is carried from the one part to the other, and the whole's
        let arms = [27.11325 - 15.0, 5.0];
        let moved = [whole[3] - arms[1] * whole[2], whole[4] + arms[0] * whole[2]];
        assert!((outer[2] + inner[2] - whole[2]).abs() < 1e-9 * outer[2].abs());
        for (row, expected) in [3, 4].into_iter().zip(moved) {
            let off = outer[row] + inner[row] - expected;
            assert!(
                off.abs() < 1e-9 * outer[3].abs().max(air[3].abs()),
                "row {row}: {outer:?} {inner:?} {whole:?}"
            );
        }
        // the wing lifts more than the 2000 lbf it weighs, tip up
        assert!(outer[2] > 0.0 && outer[3] > 0.0, "{outer:?}");
    }
}

#[test]
fn the_balance_of_a_wind_tunnel_s_deck_reads_what_all_boxes_put_on_it_in_sign_and_size() {
    // the shipped wing as a deck: its MONPNT3 ROOT is on the one grid that is held. By virtual work a spline carries all of the air's force
    // and moment, so the balance reads the sum over the boxes (of the lattice, without any structure), and weight where the wing is accelerated
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/tuflex/wing_beam.ron");
    let file = WingFile::read(&path).expect("the shipped wing");
    let options = DeckOptions { modes: 4, bars: false, corrections: None };
    let mut text = NastranDeck::of(&file, &options).expect("a deck").text;
    let (balance, more) =
        (file.balance, "AESTAT,901,ANGLEA\nAESTAT,902,URDD3\nAECOMP,ALL,CAERO,100001,200001\n");
    let monitor = format!(
        "{more}MONPNT1,AIR     ,all boxes\n,123456,ALL,0,{:?},{:?},{:?}\n",
        balance.x_m, balance.y_m, balance.z_m
    );
    let at = text.find("ENDDATA").unwrap_or(text.len());
    text.insert_str(at, &monitor);
    let bulk = parse_deck("wing", &text).expect("cards that are right");
    let deck = TrimDeck::new(&bulk, 0.0).expect("a clamped wing");
    assert!(deck.skipped_monitors.is_empty(), "{:?}", deck.skipped_monitors);
    let loads = |q: f64, alpha: f64, g: f64| {
        let value = |name: &String| match name.as_str() {
            "ANGLEA" => alpha,
            "URDD3" => g,
            _ => 0.0,
        };
        let fixed: Vec<(String, f64)> =
            deck.variables[1..].iter().map(|name| (name.clone(), value(name))).collect();
        deck.trim(q, &fixed).expect("held").monitors
    };
    let blown = loads(980.0, 0.07, 0.0);
    let (root, air) = (blown["ROOT"], blown["AIR"]);
    let size = air.iter().fold(0.0_f64, |most, load| most.max(load.abs()));
    assert!(root[2] > 50.0 && root[3] > 30.0, "up, and tip up: {root:?}");
    for (ours, boxes) in root.iter().zip(&air) {
        assert!((ours - boxes).abs() < 1e-9 * size, "{root:?} {air:?}");
    }
    // at rest, accelerated upwards by gravity: the wing's weight hangs on the balance
    let mass_kg = 2.2004;
    let hung = loads(1e-9, 0.0, 9.806_65)["ROOT"];
    assert!((hung[2] / (-mass_kg * 9.806_65) - 1.0).abs() < 1e-4, "{hung:?}");
    // another grid held beside it takes its share: nothing is said then
    let beside = text.replace("BEGIN BULK\n", "BEGIN BULK\nSPC1,1,3,1037\n");
    let beside = parse_deck("wing", &beside).expect("cards that are right");
    assert_eq!(TrimDeck::new(&beside, 0.0).expect("a clamped wing").skipped_monitors, ["ROOT"]);
}
