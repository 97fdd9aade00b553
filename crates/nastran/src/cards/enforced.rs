//! Motions that a load set enforces: SPCD.

use super::prelude::*;
use crate::motion::Motion;

/// An enforced motion (SPCD), which holds where its set is the subcase's LOAD; an SPC or SPC1 holds the same motion.
#[derive(Debug, Clone, PartialEq)]
pub struct Spcd {
    /// Load set.
    pub set: u32,
    /// Grid and component; component 0 at a scalar point.
    pub motion: Motion,
    /// Displacement or rotation in the grid's displacement system.
    pub value: f64,
    /// Where the card stands.
    pub span: Span,
}

impl DeckCard for Spcd {
    keyed!(u32, set);
    /// SPCD: SID G1 C1 D1 G2 C2 D2.
    fn read(card: &Card) -> Result<Vec<Self>, InputError> {
        card.ends_after(7)?;
        let set = card.id(0, "SID")?;
        let mut all = Vec::new();
        for at in [1, 4] {
            if at > 1 && (at..at + 3).all(|index| card.text(index).is_empty()) {
                continue;
            }
            let (grid, components) = (card.id(at, "G")?, card.components(at + 1, "C")?);
            let value = card.real_or(at + 2, "D", 0.0)?;
            let digits = if components.is_empty() { vec![0] } else { components };
            let item = |digit: u8| Self { set, motion: (grid, digit), value, span: card.span.clone() };
            all.extend(digits.into_iter().map(item));
        }
        Ok(all)
    }

    fn write(&self, card: Fields) -> Fields {
        card.int(self.set).motion(Some(self.motion)).real(self.value)
    }

    // Sets keep their numbers.
    raises!(cards: motion);

    // An image has no case control that selects loads.
    no_image!();
}
