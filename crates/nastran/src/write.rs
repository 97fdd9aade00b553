//! Decks out: the cards of a [`BulkData`] as a bulk data section.
//!
//! A card is written in 8-character fields if they hold its numbers exactly, and in 16-character fields
//! otherwise. These hold 15 digits of a positive number and 14 of a negative one as long as it needs no
//! exponent; the relative rounding error is at most 1e-11 for magnitudes from 1e-9 to 1e9 and 1e-9 for all
//! others. What is read from a written deck is written again in the same way, without any loss.
//!
//! DMI matrices are written by [`Dmi::write`](crate::Dmi::write), in 8-character fields.

use crate::bulk_data::{BulkData, Visitor};
use crate::card::fields::Fields;
use crate::cards::kind::{CardKind, Cards, DeckCard};
use std::fmt::Write as _;

/// Parameters whose value is real even if it is a whole number; the type matters to Nastran.
const REAL_PARAMETERS: [&str; 22] = [
    "AUNITS", "CONFAC", "EPPRT", "EPZERO", "FRQDEP", "G", "GFL", "HFREQ", "K6ROT", "LFREQ", "MACH",
    "MAXRATIO", "NDAMP", "Q", "SIGMA", "SNORM", "TABS", "TINY", "VREF", "W3", "W4", "WTMASS",
];

/// The bulk data section with all cards of `deck`, from a comment on what cannot be written to `ENDDATA`.
///
/// Lists are written in full, without `THRU`. Cards that were not read ([`BulkData::unknown`]) cannot be
/// written; a comment says how many there were.
pub fn write_deck(deck: &BulkData) -> String {
    let mut text = String::new();
    for (name, unread) in &deck.unknown {
        let _ = writeln!(text, "$ not written because not read: {} {name}", unread.count);
    }
    let linked = !deck.aero_links.is_empty() || !deck.aero_components.is_empty();
    if linked || deck.aero_reference.is_some() || !deck.trims.is_empty() || !deck.supports.is_empty() {
        text.push_str("$ not written: case control, AEROS, AESTAT, TRIM, SUPORT, AELINK and AECOMP\n");
    }
    if deck.bars_twist {
        text.push_str("$ not written: NASTRAN BARMASS = 1, with which bars have twisting inertia\n");
    }
    text.push_str("BEGIN BULK\n");
    deck.parameters.iter().for_each(|(name, value)| text.push_str(&parameter(name, *value)));
    deck.visit(&mut Text(&mut text));
    for matrix in deck.matrices.values() {
        text.push_str(&matrix.write());
    }
    text.push_str("ENDDATA\n");
    text
}

/// The text so far.
struct Text<'a>(&'a mut String);

impl Visitor for Text<'_> {
    fn cards(&mut self, kind: &CardKind, cards: &impl Cards) {
        for card in cards.each() {
            self.0.push_str(&card.write(Fields::new(kind.name(card))).write());
        }
    }
}

fn parameter(name: &str, value: f64) -> String {
    let card = Fields::new("PARAM").text(name);
    if name == "AUTOSPC" {
        return card.text(if value == 0.0 { "NO" } else { "YES" }).write();
    }
    let is_whole = value.fract() == 0.0 && value.abs() < 1e8 && !REAL_PARAMETERS.contains(&name);
    if is_whole { card.text(format!("{value:.0}")).write() } else { card.real(value).write() }
}
