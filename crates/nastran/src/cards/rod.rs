//! Rods: CROD and PROD.

use super::prelude::*;

/// A rod with axial and torsional stiffness (CROD).
#[derive(Debug, Clone, PartialEq)]
pub struct Crod {
    /// Identification number.
    pub id: u32,
    /// PROD.
    pub property: u32,
    /// End grids.
    pub grids: [u32; 2],
    /// Where the card stands.
    pub span: Span,
}

impl DeckCard for Crod {
    numbered!();
    /// CROD: EID PID G1 G2.
    fn read(card: &Card) -> Result<Vec<Self>, InputError> {
        card.ends_after(4)?;
        let id = card.id(0, "EID")?;
        let property = card.id_or(1, "PID", id)?;
        let grids = card.corners(2, &["G1", "G2"])?;
        Ok(vec![Crod { id, property, grids: [grids[0], grids[1]], span: card.span.clone() }])
    }

    fn write(&self, card: Fields) -> Fields {
        card.ints([self.id, self.property]).ints(self.grids)
    }

    raises!(cards: id, property, grids);

    own_image!();
}

/// A rod's property (PROD).
#[derive(Debug, Clone, PartialEq)]
pub struct Prod {
    /// Identification number.
    pub id: u32,
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

impl DeckCard for Prod {
    numbered!();
    /// PROD: PID MID A J C NSM; the stress coefficient C is skipped.
    fn read(card: &Card) -> Result<Vec<Self>, InputError> {
        card.ends_after(6)?;
        Ok(vec![Prod {
            id: card.id(0, "PID")?,
            material: card.id(1, "MID")?,
            area: card.not_negative(2, "A", 0.0)?,
            j: card.not_negative(3, "J", 0.0)?,
            nsm: card.real_or(5, "NSM", 0.0)?,
            span: card.span.clone(),
        }])
    }

    fn write(&self, card: Fields) -> Fields {
        card.ints([self.id, self.material]).reals(&[self.area, self.j]).blanks(1).real(self.nsm)
    }

    raises!(cards: id, material);

    own_image!();
}
