//! Numbers that cards of different names must not share.
//!
//! Nastran numbers all elements with stiffness together, whatever their kind; so are mass elements, rigid elements,
//! the properties one element card may refer to, and materials. Masses and rigid elements are counted apart
//! from the others: decks that give them the numbers of elements are in use, and nothing in them is ambiguous.

use crate::card::Card;
use crate::source::{InputError, Span};
use std::collections::BTreeMap;

/// The kinds of cards that share their numbers.
const FAMILIES: [(&str, &[&str]); 6] = [
    (
        "element",
        &[
            "CBAR", "CBEAM", "CQUAD4", "CTRIA3", "CHEXA", "CPENTA", "CTETRA", "CROD", "CBUSH", "CELAS1",
            "CELAS2", "GENEL",
        ],
    ),
    ("mass element", &["CONM1", "CONM2", "CMASS1", "CMASS2"]),
    ("rigid element", &["RBE2", "RBE3", "RBAR"]),
    ("shell property", &["PSHELL", "PCOMP", "PCOMPG"]),
    ("beam property", &["PBAR", "PBARL", "PBEAM", "PBEAML"]),
    ("material", &["MAT1", "MAT2", "MAT8", "MAT9"]),
];

/// The numbers that are taken, by family.
#[derive(Debug, Default)]
pub(crate) struct Numbers {
    taken: BTreeMap<(&'static str, u32), (String, Span)>,
}

impl Numbers {
    /// Takes the number of a card; an error if a card of its family has it already.
    pub(crate) fn claim(&mut self, card: &Card) -> Result<(), InputError> {
        let family = FAMILIES.iter().find(|(_, names)| names.contains(&card.name.as_str()));
        let Some((family, _)) = family else { return Ok(()) };
        let id = card.id(0, "the number")?;
        let before = self.taken.insert((*family, id), (card.name.clone(), card.span.clone()));
        let Some((name, span)) = before else { return Ok(()) };
        let message = if name == card.name {
            format!("{name} {id} is given twice; the number or name is taken since {span}")
        } else {
            format!("{} {id} has the number of another {family}, {name} {id} at {span}", card.name)
        };
        Err(card.error(0, message).with_help("give every card its own number or name"))
    }
}
