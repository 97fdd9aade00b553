//! Rods with their section on the card: CONROD.

use super::prelude::*;

/// A rod that names its material itself (CONROD).
#[derive(Debug, Clone, PartialEq)]
pub struct Conrod {
    /// Identification number.
    pub id: u32,
    /// End grids.
    pub grids: [u32; 2],
    /// MAT1.
    pub material: u32,
    /// Area.
    pub area: f64,
    /// Torsional constant.
    pub j: f64,
    /// Non-structural mass per length.
    pub nsm: f64,
    /// Where the card stands.
    pub span: Span,
}

impl DeckCard for Conrod {
    numbered!();
    /// CONROD: EID G1 G2 MID A J C NSM; the stress coefficient C is skipped.
    fn read(card: &Card) -> Result<Vec<Self>, InputError> {
        card.ends_after(8)?;
        let grids = card.corners(1, &["G1", "G2"])?;
        Ok(vec![Conrod {
            id: card.id(0, "EID")?,
            grids: [grids[0], grids[1]],
            material: card.id(3, "MID")?,
            area: card.not_negative(4, "A", 0.0)?,
            j: card.not_negative(5, "J", 0.0)?,
            nsm: card.real_or(7, "NSM", 0.0)?,
            span: card.span.clone(),
        }])
    }

    fn write(&self, card: Fields) -> Fields {
        card.ints([self.id])
            .ints(self.grids)
            .ints([self.material])
            .reals(&[self.area, self.j])
            .blanks(1)
            .real(self.nsm)
    }

    raises!(cards: id, grids, material);

    own_image!();
}
