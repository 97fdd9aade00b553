//! Shear panels: CSHEAR and PSHEAR.

use super::prelude::*;

/// A panel that carries shear alone (CSHEAR).
#[derive(Debug, Clone, PartialEq)]
pub struct Cshear {
    /// Identification number.
    pub id: u32,
    /// PSHEAR.
    pub property: u32,
    /// Corner grids in order around the panel.
    pub grids: [u32; 4],
    /// Where the card stands.
    pub span: Span,
}

impl DeckCard for Cshear {
    numbered!();
    /// CSHEAR: EID PID G1 G2 G3 G4.
    fn read(card: &Card) -> Result<Vec<Self>, InputError> {
        card.ends_after(6)?;
        let id = card.id(0, "EID")?;
        let property = card.id_or(1, "PID", id)?;
        let grids = card.corners(2, &["G1", "G2", "G3", "G4"])?;
        let grids = [grids[0], grids[1], grids[2], grids[3]];
        Ok(vec![Cshear { id, property, grids, span: card.span.clone() }])
    }

    fn write(&self, card: Fields) -> Fields {
        card.ints([self.id, self.property]).ints(self.grids)
    }

    raises!(cards: id, property, grids);

    own_image!();
}

/// A shear panel's property (PSHEAR).
#[derive(Debug, Clone, PartialEq)]
pub struct Pshear {
    /// Identification number.
    pub id: u32,
    /// MAT1.
    pub material: u32,
    /// T.
    pub thickness: f64,
    /// Non-structural mass per area.
    pub nsm: f64,
    /// F1, F2: how much of the panel carries direct stress along sides 1-2 and 3-4, and along 2-3 and 4-1.
    pub extensional: [f64; 2],
    /// Where the card stands.
    pub span: Span,
}

impl DeckCard for Pshear {
    numbered!();
    /// PSHEAR: PID MID T NSM F1 F2.
    fn read(card: &Card) -> Result<Vec<Self>, InputError> {
        card.ends_after(6)?;
        Ok(vec![Pshear {
            id: card.id(0, "PID")?,
            material: card.id(1, "MID")?,
            thickness: card.positive(2, "T")?,
            nsm: card.real_or(3, "NSM", 0.0)?,
            extensional: [card.not_negative(4, "F1", 0.0)?, card.not_negative(5, "F2", 0.0)?],
            span: card.span.clone(),
        }])
    }

    fn write(&self, card: Fields) -> Fields {
        card.ints([self.id, self.material]).reals(&[self.thickness, self.nsm]).reals(&self.extensional)
    }

    raises!(cards: id, material);

    own_image!();
}
