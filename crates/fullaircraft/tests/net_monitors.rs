//! MONPNT3 of decks: net loads on grids, by their laws on HA144A.

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
