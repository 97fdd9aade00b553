//! Dampers between grids: CVISC and PVISC.

use super::prelude::*;

/// A damper along the line between two grids (CVISC).
#[derive(Debug, Clone, PartialEq)]
pub struct Cvisc {
    /// Identification number.
    pub id: u32,
    /// PVISC.
    pub property: u32,
    /// End grids.
    pub grids: [u32; 2],
    /// Where the card stands.
    pub span: Span,
}

impl DeckCard for Cvisc {
    numbered!();
    /// CVISC: EID PID G1 G2.
    fn read(card: &Card) -> Result<Vec<Self>, InputError> {
        card.ends_after(4)?;
        let id = card.id(0, "EID")?;
        let (property, grids) = (card.id_or(1, "PID", id)?, card.corners(2, &["G1", "G2"])?);
        Ok(vec![Cvisc { id, property, grids: [grids[0], grids[1]], span: card.span.clone() }])
    }

    fn write(&self, card: Fields) -> Fields {
        card.ints([self.id, self.property]).ints(self.grids)
    }

    raises!(cards: id, property, grids);

    own_image!();
}

/// A damper's property (PVISC).
#[derive(Debug, Clone, PartialEq)]
pub struct Pvisc {
    /// Identification number.
    pub id: u32,
    /// CE: force per velocity of extension.
    pub stretch: f64,
    /// CR: moment per angular velocity about the line.
    pub twist: f64,
    /// Where the card stands.
    pub span: Span,
}

impl DeckCard for Pvisc {
    numbered!();
    /// PVISC: PID CE CR blank, twice on one card.
    fn read(card: &Card) -> Result<Vec<Self>, InputError> {
        card.ends_after(8)?;
        let mut properties = Vec::new();
        for at in [0, 4] {
            if at == 0 || !card.text(at).is_empty() {
                let (stretch, twist) =
                    (card.not_negative(at + 1, "CE", 0.0)?, card.not_negative(at + 2, "CR", 0.0)?);
                properties.push(Pvisc { id: card.id(at, "PID")?, stretch, twist, span: card.span.clone() });
            }
        }
        Ok(properties)
    }

    fn write(&self, card: Fields) -> Fields {
        card.int(self.id).reals(&[self.stretch, self.twist])
    }

    raises!(cards: id);

    own_image!();
}
