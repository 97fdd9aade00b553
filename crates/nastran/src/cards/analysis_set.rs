//! The motions that modes are computed of: ASET, BSET and CSET keep some, OMIT leaves some out, QSET adds generalised ones; ASET1 and
//! so on are lists of them.

use super::prelude::*;

/// What a reduction makes of motions.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Reduction {
    /// They are kept (ASET, BSET, CSET).
    Kept,
    /// They follow those that are kept (OMIT).
    Omitted,
    /// They are amounts of shapes, not motions of the structure (QSET).
    Generalised,
}

/// Motions of grids and what a reduction makes of them.
#[derive(Debug, Clone, PartialEq)]
pub struct AnalysisSet {
    /// What a reduction makes of them.
    pub reduction: Reduction,
    /// Components, digits 1 to 6; none at a scalar point.
    pub components: Vec<u8>,
    /// Grids or scalar points.
    pub grids: Vec<u32>,
    /// Where the card stands.
    pub span: Span,
}

impl DeckCard for AnalysisSet {
    type Key = u32;

    fn key(&self) -> u32 {
        self.grids.first().copied().unwrap_or_default()
    }

    fn span(&self) -> &Span {
        &self.span
    }

    variant!(|card| match card.reduction {
        Reduction::Kept => 0,
        Reduction::Omitted => 1,
        Reduction::Generalised => 2,
    });

    /// ASET1: C ID1 ID2 ... or C ID1 THRU ID2. ASET: ID1 C1 ID2 C2 ... The others alike.
    fn read(card: &Card) -> Result<Vec<Self>, InputError> {
        let reduction = match card.name.as_bytes().first() {
            Some(b'O') => Reduction::Omitted,
            Some(b'Q') => Reduction::Generalised,
            _ => Reduction::Kept,
        };
        let set = |components, grids| Self { reduction, components, grids, span: card.span.clone() };
        if card.name.ends_with('1') {
            return Ok(vec![set(card.components(0, "C")?, card.id_list(1, "ID")?)]);
        }
        let places = (0..card.len().max(1)).step_by(2).filter(|at| *at == 0 || !card.text(*at).is_empty());
        places.map(|at| Ok(set(card.components(at + 1, "C")?, vec![card.id(at, "ID")?]))).collect()
    }

    fn write(&self, card: Fields) -> Fields {
        card.digits(&self.components).ints(self.grids.iter().copied())
    }

    raises!(cards: grids);

    own_image!();
}
