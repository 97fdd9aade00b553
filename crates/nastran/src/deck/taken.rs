//! Numbers that cards of different names must not share.
//!
//! Mass elements are numbered together, whatever their kind, and so are rigid elements, the properties one element card may refer to,
//! and materials. Elements with stiffness should be as well, but MSC Nastran runs decks with a CBAR and a CROD of one number: those
//! of different kinds are kept and said ([`BulkData::remarks`](crate::BulkData::remarks)), those of one kind (CBAR and CBEAM) refused.
//! Masses and rigid elements are counted apart from the others: decks that give them the numbers of elements are in use.

use crate::bulk_data::CARD_KINDS;
use crate::card::Card;
use crate::cards::kind::Family;
use crate::source::{InputError, Span};
use std::collections::BTreeMap;

/// The numbers that are taken.
#[derive(Debug, Default)]
pub(crate) struct Numbers {
    /// Name and place of a card by its family (an element's by its kind) and number.
    taken: BTreeMap<(&'static str, u32), (String, Span)>,
}

impl Numbers {
    /// Takes the number of a card; an error if a card of its family has it already.
    pub(crate) fn claim(&mut self, card: &Card) -> Result<(), InputError> {
        let kind = CARD_KINDS.iter().find(|kind| kind.names.contains(&card.name.as_str()));
        let Some((kind, family)) = kind.and_then(|kind| Some((kind, kind.family.name()?))) else {
            return Ok(());
        };
        let id = card.id(0, "the number")?;
        let among = if kind.family == Family::Element { kind.field } else { family };
        let before = self.taken.insert((among, id), (card.name.clone(), card.span.clone()));
        let Some((name, span)) = before else { return Ok(()) };
        if name == card.name {
            return Err(card.twice(&format!("{name} {id}"), &span));
        }
        let message = format!("{} {id} has the number of another {family}, {name} {id} at {span}", card.name);
        Err(card.error(0, message).with_help("give every card its own number or name"))
    }
}
