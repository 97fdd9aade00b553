//! Springs and dampers along one axis: CBUSH1D and PBUSH1D.

use super::prelude::*;

/// A spring and damper along one axis (CBUSH1D).
#[derive(Debug, Clone, PartialEq)]
pub struct Cbush1d {
    /// Identification number.
    pub id: u32,
    /// PBUSH1D.
    pub property: u32,
    /// End grids; without a second one it ends at the ground.
    pub grids: (u32, Option<u32>),
    /// CID: the coordinate system whose x axis is the element's, in the place of the line between the grids.
    pub system: Option<u32>,
    /// Where the card stands.
    pub span: Span,
}

impl DeckCard for Cbush1d {
    numbered!();
    /// CBUSH1D: EID PID GA GB CID.
    fn read(card: &Card) -> Result<Vec<Self>, InputError> {
        card.ends_after(5)?;
        let id = card.id(0, "EID")?;
        let grids = (card.id(2, "GA")?, card.optional_id(3, "GB")?);
        if grids.1 == Some(grids.0) {
            return Err(card.error(3, format!("grid {} stands twice in CBUSH1D {id}", grids.0)));
        }
        let system = if card.text(4).is_empty() { None } else { Some(card.count_or(4, "CID", 0)?) };
        if grids.1.is_none() && system.is_none() {
            let message = format!("CBUSH1D {id} ends at the ground but names no coordinate system in CID");
            return Err(card
                .error(4, message)
                .with_help("give CID, whose x axis is the element's; 0 is the basic system"));
        }
        Ok(vec![Cbush1d { id, property: card.id_or(1, "PID", id)?, grids, system, span: card.span.clone() }])
    }

    fn write(&self, card: Fields) -> Fields {
        let card = card.ints([self.id, self.property, self.grids.0]).optional(self.grids.1);
        card.optional(self.system)
    }

    raises!(cards: id, property, grids; systems: system);

    own_image!();
}

/// Its property (PBUSH1D): what it is in linear solutions.
#[derive(Debug, Clone, PartialEq)]
pub struct Pbush1d {
    /// Identification number.
    pub id: u32,
    /// K: force per extension.
    pub stiffness: f64,
    /// C: force per velocity of extension.
    pub damping: f64,
    /// M: mass of the element, half of it at each end.
    pub mass: f64,
    /// The first word that makes it nonlinear (SHOCKA, SPRING, DAMPER, GENER), if any.
    pub nonlinear: Option<String>,
    /// Where the card stands.
    pub span: Span,
}

impl DeckCard for Pbush1d {
    numbered!();
    /// PBUSH1D: PID K C M blank SA SE, then lines that nonlinear solutions use; coefficients of stress and strain are skipped.
    fn read(card: &Card) -> Result<Vec<Self>, InputError> {
        let words = ["SHOCKA", "SPRING", "DAMPER", "GENER"];
        let given = (0..card.len()).map(|at| card.text(at).to_ascii_uppercase());
        Ok(vec![Pbush1d {
            id: card.id(0, "PID")?,
            stiffness: card.not_negative(1, "K", 0.0)?,
            damping: card.not_negative(2, "C", 0.0)?,
            mass: card.not_negative(3, "M", 0.0)?,
            nonlinear: given.into_iter().find(|text| words.contains(&text.as_str())),
            span: card.span.clone(),
        }])
    }

    /// What nonlinear solutions use is not written: such a property is for linear ones.
    fn write(&self, card: Fields) -> Fields {
        card.int(self.id).reals(&[self.stiffness, self.damping, self.mass])
    }

    raises!(cards: id);

    own_image!();
}
