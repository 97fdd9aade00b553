//! Cards that are not read: which of them stop whom, and which are left alone.

use nastran::{BulkData, CARD_KINDS, Span, Unread, parse_deck};
use std::collections::BTreeSet;

#[test]
fn an_element_that_is_not_read_stops_with_name_number_place_and_way_out() {
    let deck = "PLOTEL,9,1,2\nGRID,1\nCTRIA1,1,1,1,2,3\nRSSCON,7\nCTRIA1,2,1,1,2,4\n";
    let error = parse_deck("wing.bdf", deck).expect("a deck").refuse_unread_elements().expect_err("CTRIA1");
    assert_eq!(
        error.to_string(),
        "wing.bdf:3:1: the deck has 2 CTRIA1 (from wing.bdf:3:1 on), 1 RSSCON (from wing.bdf:4:1 on): elements that \
         are not read, and leaving them out would change stiffness, damping, mass or constraints (hint: write CTRIA3 for \
         CTRIA1, RBE1, RBE2 or MPC for RSSCON, or take out what the model shall do without)"
    );
}

#[test]
fn dampers_stop_only_where_damping_counts() {
    let deck = parse_deck("wing.bdf", "CDAMP5,1,.5,1,3\n").expect("a deck");
    assert!(deck.refuse_unread_elements().is_err());
    assert_eq!(deck.refuse_unread_undamped(), Ok(()));
}

#[test]
fn what_has_no_stiffness_mass_or_load_is_left_alone() {
    let deck =
        "PLOTEL,9,1,2\nEIGRL,1,,,5\nASET1,123,1\nDESVAR,1,A,1.\nTABLED1,1\nFORCE,1,1,,1.,1.\nSPOINT,5\n";
    assert_eq!(parse_deck("wing.bdf", deck).expect("a deck").refuse_unread_elements(), Ok(()));
}

#[test]
fn parameters_that_are_not_read_are_named_each_once() {
    let deck = "PARAM,PRGPST,NO\nPARAM,POST,-1\nPARAM,ogeom,NO\nPARAM,PRGPST,NO\nEIGC,1,HESS\n";
    let unread = parse_deck("wing.bdf", deck).expect("a deck").unread_cards();
    assert_eq!(unread.as_deref(), Some("1 EIGC, 3 PARAM (OGEOM, PRGPST)"));
}

/// Whether a deck with a card of this name that is not read is refused.
fn is_refused(name: &str) -> bool {
    let first = Span::generated("test");
    let unread = Unread { count: 1, first, numbers: BTreeSet::new(), parameters: BTreeSet::new() };
    let deck = BulkData { unknown: [(name.to_owned(), unread)].into(), ..BulkData::default() };
    deck.refuse_unread_elements().is_err()
}

#[test]
fn no_name_is_both_read_and_refused() {
    assert!(is_refused("CTRIA1"));
    for name in CARD_KINDS.iter().flat_map(|kind| kind.names) {
        assert!(!is_refused(name), "{name}");
    }
}
