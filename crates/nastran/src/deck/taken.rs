//! Numbers that cards of different names must not share.
//!
//! Nastran numbers all elements with stiffness together, whatever their kind; so are mass elements, rigid elements,
//! the properties one element card may refer to, and materials. Masses and rigid elements are counted apart
//! from the others: decks that give them the numbers of elements are in use, and nothing in them is ambiguous.

use crate::bulk_data::CARD_KINDS;
use crate::card::Card;
use crate::source::{InputError, Span};
use std::collections::BTreeMap;

/// The numbers that are taken, by family.
#[derive(Debug, Default)]
pub(crate) struct Numbers {
    taken: BTreeMap<(&'static str, u32), (String, Span)>,
}

impl Numbers {
    /// Takes the number of a card; an error if a card of its family has it already.
    pub(crate) fn claim(&mut self, card: &Card) -> Result<(), InputError> {
        let kind = CARD_KINDS.iter().find(|kind| kind.names.contains(&card.name.as_str()));
        let Some(family) = kind.and_then(|kind| kind.family.name()) else { return Ok(()) };
        let id = card.id(0, "the number")?;
        let before = self.taken.insert((family, id), (card.name.clone(), card.span.clone()));
        let Some((name, span)) = before else { return Ok(()) };
        if name == card.name {
            return Err(card.twice(&format!("{name} {id}"), &span));
        }
        let message = format!("{} {id} has the number of another {family}, {name} {id} at {span}", card.name);
        Err(card.error(0, message).with_help("give every card its own number or name"))
    }
}
