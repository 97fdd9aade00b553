//! Grid points and lists of their numbers: GRID and SET1.

use super::prelude::*;
use nalgebra::Point3;

/// A grid point (GRID).
#[derive(Debug, Clone, PartialEq)]
pub struct Grid {
    /// Identification number.
    pub id: u32,
    /// Coordinate system of `xyz`; 0 is basic.
    pub cp: u32,
    /// Coordinates in `cp` (as its [`crate::CoordKind`] says).
    pub xyz: Point3<f64>,
    /// Displacement coordinate system; 0 is basic.
    pub cd: u32,
    /// Permanently fixed components, digits 1 to 6.
    pub ps: Vec<u8>,
    /// Where the card stands.
    pub span: Span,
}

impl DeckCard for Grid {
    numbered!();
    /// GRID: ID CP X1 X2 X3 CD PS.
    fn read(card: &Card) -> Result<Vec<Self>, InputError> {
        if card.text(5) == "-1" {
            let message = format!("GRID {} is a point of a fluid (CD = -1), which is not read", card.text(0));
            return Err(card.error(5, message).with_help("take the fluid out: wingroot has no acoustics"));
        }
        Ok(vec![Grid {
            id: card.id(0, "ID")?,
            cp: card.count_or(1, "CP", 0)?,
            xyz: card.vector(2, ["X1", "X2", "X3"])?,
            cd: card.count_or(5, "CD", 0)?,
            ps: card.components(6, "PS")?,
            span: card.span.clone(),
        }])
    }

    fn write(&self, card: Fields) -> Fields {
        card.ints([self.id, self.cp]).reals(&self.xyz.coords).int(self.cd).digits(&self.ps)
    }

    raises!(cards: id; systems: cp, cd);

    fn mirrored(self, mirror: &Mirror) -> Mirrored<Self> {
        if self.cd != 0 {
            let message =
                format!("GRID {} has displacement system {}, so it cannot be mirrored", self.id, self.cd);
            return Err(
                InputError::at(&self.span, message).with_help("set field CD of the wing's grids to 0")
            );
        }
        let xyz = mirror.place(self.cp, self.xyz, &self.span)?;
        Ok(Some(Self { cp: 0, xyz, ..self }))
    }
}

/// A list of grids (SET1), THRU expanded.
#[derive(Debug, Clone, PartialEq)]
pub struct Set1 {
    /// Identification number.
    pub id: u32,
    /// Identification numbers.
    pub ids: Vec<u32>,
    /// Where the card stands.
    pub span: Span,
}

impl DeckCard for Set1 {
    numbered!();
    /// SET1: SID ID1 ID2 ... or ID1 THRU ID2.
    fn read(card: &Card) -> Result<Vec<Self>, InputError> {
        Ok(vec![Set1 { id: card.id(0, "SID")?, ids: card.id_list(1, "ID")?, span: card.span.clone() }])
    }

    fn write(&self, card: Fields) -> Fields {
        card.int(self.id).ints(self.ids.iter().copied())
    }

    raises!(cards: id, ids);

    own_image!();
}
