//! Scalar points: SPOINT.

use super::prelude::*;

/// A point with one motion and no place (SPOINT, or named by CELAS3, CELAS4, CMASS3 or CMASS4).
#[derive(Debug, Clone, PartialEq)]
pub struct Spoint {
    /// Identification number, which no grid has.
    pub id: u32,
    /// Where the card stands.
    pub span: Span,
}

impl DeckCard for Spoint {
    numbered!();
    /// SPOINT: ID1 ID2 ... or ID1 THRU ID2.
    fn read(card: &Card) -> Result<Vec<Self>, InputError> {
        let ids = card.id_list(0, "ID")?;
        Ok(ids.into_iter().map(|id| Self { id, span: card.span.clone() }).collect())
    }

    fn write(&self, card: Fields) -> Fields {
        card.int(self.id)
    }

    raises!(cards: id);

    own_image!();
}
