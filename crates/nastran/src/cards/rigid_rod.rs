//! Rigid rods: RROD. Thermal expansion is skipped.

use super::prelude::*;

/// Two grids that keep their distance (RROD).
#[derive(Debug, Clone, PartialEq)]
pub struct Rrod {
    /// Identification number.
    pub id: u32,
    /// End grids.
    pub grids: [u32; 2],
    /// The motion that follows: which end (0 or 1), and its component 1, 2 or 3.
    pub dependent: (usize, u8),
    /// Where the card stands.
    pub span: Span,
}

impl DeckCard for Rrod {
    numbered!();
    /// RROD: EID GA GB CMA CMB ALPHA TREF.
    fn read(card: &Card) -> Result<Vec<Self>, InputError> {
        card.ends_after(7)?;
        let grids = card.corners(1, &["GA", "GB"])?;
        let digits = [card.components(3, "CMA")?, card.components(4, "CMB")?];
        let dependent = match [digits[0].as_slice(), digits[1].as_slice()] {
            [[digit @ 1..=3], []] => (0, *digit),
            [[], [digit @ 1..=3]] => (1, *digit),
            _ => return Err(card.wrong(3, "CMA", "1, 2 or 3, and CMB empty, or the other way round")),
        };
        let id = card.id(0, "EID")?;
        Ok(vec![Rrod { id, grids: [grids[0], grids[1]], dependent, span: card.span.clone() }])
    }

    fn write(&self, card: Fields) -> Fields {
        let (end, digit) = self.dependent;
        card.int(self.id).ints(self.grids).blanks(end).digits(&[digit])
    }

    raises!(cards: id, grids);

    own_image!();
}
