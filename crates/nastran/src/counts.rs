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
