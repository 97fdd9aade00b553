//! How many elements of each kind a deck has, by the names of their cards.

use crate::bulk_data::{BulkData, Visitor};
use crate::cards::kind::{CardKind, Cards};
use std::collections::BTreeMap;

/// Elements by the name of their card.
#[derive(Default)]
struct Counts(BTreeMap<&'static str, usize>);

impl Visitor for Counts {
    fn cards(&mut self, kind: &CardKind, cards: &impl Cards) {
        for card in cards.each().filter(|_| kind.family.is_element()) {
            *self.0.entry(kind.name(card)).or_default() += 1;
        }
    }
}

impl BulkData {
    /// Elements (structural ones, masses, springs, rigid elements) by card name; kinds that do not occur are left
    /// out.
    pub fn element_counts(&self) -> BTreeMap<&'static str, usize> {
        let mut counts = Counts::default();
        self.visit(&mut counts);
        counts.0
    }
}

#[cfg(test)]
mod tests {
    #[test]
    fn elements_are_counted_by_the_name_of_their_card() {
        let deck = "GRID,1\nGRID,2,,1.\nCBAR,1,1,1,2,0.,0.,1.\nCBEAM,2,1,1,2,0.,0.,1.\nCBEAM,3,1,1,2,0.,0.,1.\n\
                    CONM2,1,2,,1.\nRBE2,9,1,123456,2\n";
        let counts = crate::parse_deck("deck", deck).expect("a deck").element_counts();
        let expected = [("CBAR", 1), ("CBEAM", 2), ("CONM2", 1), ("RBE2", 1)];
        assert_eq!(counts.into_iter().collect::<Vec<_>>(), expected);
    }
}
