//! Loads of a subcase on a trimmed deck.

use fullaircraft::{Elastic, TrimDeck};
use nastran::{BulkData, parse_deck};
use std::path::Path;

/// HA144A with more cards.
fn deck(more: &str) -> BulkData {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/published/decks/ha144a_fsw.bdf");
    let text = std::fs::read_to_string(path).expect("the shipped deck");
    parse_deck("ha144a", &text.replace("ENDDATA", &format!("{more}ENDDATA"))).expect("cards that are right")
}

/// Weight as a load (GRAV of the subcase's LOAD) is the opposite acceleration: one g of pull-up by URDD3, or by weight at rest.
#[test]
fn a_load_of_the_subcase_acts_beside_air_and_inertia() {
    let bulk = deck("GRAV,5,,32.174,0.,0.,-1.\nSPCD,6,100,3,.1\n");
    let card = bulk.trims[&1].clone();
    let plain = TrimDeck::new(&bulk, 0.9).unwrap();
    let expected = plain.trim_card(&card).unwrap();
    let mut at_rest = card.clone();
    let urdd3 = at_rest.fixed.iter_mut().find(|(name, _)| name == "URDD3").expect("it pulls up");
    let units = bulk.parameters["AUNITS"];
    // a = URDD3 / AUNITS
    let scale = -urdd3.1 / units / 32.174;
    assert!((scale - 1.0).abs() < 1e-4, "{scale}");
    urdd3.1 += units * 32.174;
    let loaded = TrimDeck::under_load(&bulk, 0.9, Some(5)).unwrap();
    let found = loaded.trim_card(&at_rest).unwrap();
    for label in ["ANGLEA", "ELEV"] {
        let (found, expected) = (found.values[label], expected.values[label]);
        assert!((found - expected).abs() <= 1e-9 * expected.abs(), "{label}: {found} {expected}");
    }
    for (name, expected) in plain.derivatives(1200.0, Elastic::Restrained) {
        assert_eq!(loaded.derivatives(1200.0, Elastic::Restrained)[&name], expected, "{name}");
    }
    assert!(expected.mean_angle_of_attack_rad.is_some() && found.mean_angle_of_attack_rad.is_none());
    let missing = TrimDeck::under_load(&bulk, 0.9, Some(9)).unwrap_err().to_string();
    assert!(missing.contains('9'), "{missing}");
    let enforced = TrimDeck::under_load(&bulk, 0.9, Some(6)).unwrap_err().to_string();
    assert!(enforced.contains("SPCD of set 6 enforces a motion"), "{enforced}");
}
