//! Accelerations of single grids as loads: ACCEL1.

use super::prelude::*;
use nalgebra::Vector3;

/// An acceleration of the masses at some grids (ACCEL1).
#[derive(Debug, Clone, PartialEq)]
pub struct Acceleration {
    /// Load set.
    pub set: u32,
    /// Coordinate system of the vector.
    pub cid: u32,
    /// Scale times vector; what it pushes is pushed along it, as by GRAV.
    pub vector: Vector3<f64>,
    /// The grids.
    pub grids: Vec<u32>,
    /// Where the card stands.
    pub span: Span,
}

impl DeckCard for Acceleration {
    keyed!(u32, set);
    /// ACCEL1: SID CID A N1 N2 N3 / GRIDID1 GRIDID2 ...
    fn read(card: &Card) -> Result<Vec<Self>, InputError> {
        Ok(vec![Self {
            set: card.id(0, "SID")?,
            cid: card.count_or(1, "CID", 0)?,
            vector: card.vector::<Vector3<f64>>(3, ["N1", "N2", "N3"])? * card.real(2, "A")?,
            grids: card.id_list(8, "GRIDID")?,
            span: card.span.clone(),
        }])
    }

    fn write(&self, card: Fields) -> Fields {
        let card = card.ints([self.set, self.cid]).real(1.0).reals(&self.vector);
        card.next_line().ints(self.grids.iter().copied())
    }

    // Sets keep their numbers.
    raises!(cards: grids; systems: cid);

    // An image has no case control that selects loads.
    no_image!();
}
