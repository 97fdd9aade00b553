//! Loads of a structure that turns about an axis: RFORCE.

use super::prelude::*;
use nalgebra::Vector3;

/// What a steady rotation pushes every mass outward with (RFORCE).
#[derive(Debug, Clone, PartialEq)]
pub struct Spin {
    /// Load set.
    pub set: u32,
    /// A grid on the axis; without one it goes through the origin of the basic system.
    pub grid: Option<u32>,
    /// Coordinate system of the vector.
    pub cid: u32,
    /// Along the axis: revolutions per unit of time.
    pub turns_per_s: Vector3<f64>,
    /// Where the card stands.
    pub span: Span,
}

impl DeckCard for Spin {
    keyed!(u32, set);
    /// RFORCE: SID G CID A R1 R2 R3 METHOD RACC MB IDRF; METHOD and MB make no difference to a steady rotation of what does not move.
    fn read(card: &Card) -> Result<Vec<Self>, InputError> {
        card.ends_after(11)?;
        if !matches!(card.count_or(7, "METHOD", 1)?, 1 | 2) {
            return Err(card.wrong(7, "METHOD", "1 or 2"));
        }
        if card.real_or(8, "RACC", 0.0)? != 0.0 {
            let message = "RFORCE with an angular acceleration (RACC) is not read";
            return Err(card
                .error(8, message)
                .with_help("programs differ in its sign: give its forces as FORCE"));
        }
        if card.count_or(10, "IDRF", 0)? != 0 {
            let message = "RFORCE on the elements of a set (IDRF) is not read";
            return Err(card.error(10, message).with_help("leave it empty: all masses turn"));
        }
        let grid = card.count_or(1, "G", 0)?;
        Ok(vec![Self {
            set: card.id(0, "SID")?,
            grid: (grid > 0).then_some(grid),
            cid: card.count_or(2, "CID", 0)?,
            turns_per_s: card.vector::<Vector3<f64>>(4, ["R1", "R2", "R3"])? * card.real(3, "A")?,
            span: card.span.clone(),
        }])
    }

    fn write(&self, card: Fields) -> Fields {
        card.ints([self.set, self.grid.unwrap_or(0), self.cid]).real(1.0).reals(&self.turns_per_s)
    }

    // Sets keep their numbers.
    raises!(cards: grid; systems: cid);

    // An image has no case control that selects loads.
    no_image!();
}
