//! Coordinate systems: CORD1R, CORD1C, CORD1S, CORD2R, CORD2C and CORD2S.

use super::prelude::*;
use nalgebra::Point3;

/// What the three coordinates of a system are.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum CoordKind {
    /// x, y, z (CORD1R, CORD2R).
    #[default]
    Rectangular,
    /// r, theta in degrees from x, z (CORD1C, CORD2C).
    Cylindrical,
    /// r, theta in degrees from z, phi in degrees from x about z (CORD1S, CORD2S).
    Spherical,
}

/// How a coordinate system is given.
#[derive(Debug, Clone, PartialEq)]
pub enum CoordDefinition {
    /// CORD2R, CORD2C, CORD2S: origin, a point on the z axis, a point in the xz plane, all in system `rid`.
    Points {
        /// Reference system.
        rid: u32,
        /// Origin.
        a: Point3<f64>,
        /// On the z axis.
        b: Point3<f64>,
        /// In the xz plane.
        c: Point3<f64>,
    },
    /// CORD1R, CORD1C, CORD1S: the same three points given by grids.
    Grids([u32; 3]),
}

/// A coordinate system (CORD1R, CORD1C, CORD1S, CORD2R, CORD2C, CORD2S).
#[derive(Debug, Clone, PartialEq)]
pub struct Coord {
    /// Identification number.
    pub id: u32,
    /// Rectangular, cylindrical or spherical.
    pub kind: CoordKind,
    /// The three points that define it.
    pub definition: CoordDefinition,
    /// Where the card stands.
    pub span: Span,
}

impl DeckCard for Coord {
    numbered!();
    fn variant(&self) -> usize {
        let by_grids = matches!(self.definition, CoordDefinition::Grids(_));
        self.kind as usize + 3 * usize::from(by_grids)
    }

    /// CORD2R, CORD2C, CORD2S: CID RID A1 A2 A3 B1 B2 B3 / C1 C2 C3, and
    /// CORD1R, CORD1C, CORD1S: CID G1 G2 G3, twice on one card.
    fn read(card: &Card) -> Result<Vec<Self>, InputError> {
        let kind = match card.name.chars().last() {
            Some('C') => CoordKind::Cylindrical,
            Some('S') => CoordKind::Spherical,
            _ => CoordKind::Rectangular,
        };
        let system = |from: usize, definition: CoordDefinition| -> Result<Self, InputError> {
            Ok(Self { id: card.id(from, "CID")?, kind, definition, span: card.span.clone() })
        };
        if card.name.starts_with("CORD2") {
            let definition = CoordDefinition::Points {
                rid: card.count_or(1, "RID", 0)?,
                a: card.vector(2, ["A1", "A2", "A3"])?,
                b: card.vector(5, ["B1", "B2", "B3"])?,
                c: card.vector(8, ["C1", "C2", "C3"])?,
            };
            return Ok(vec![system(0, definition)?]);
        }
        let mut systems = Vec::new();
        for from in [0, 4].into_iter().filter(|from| *from == 0 || card.len() > *from) {
            let grids = [card.id(from + 1, "G1")?, card.id(from + 2, "G2")?, card.id(from + 3, "G3")?];
            systems.push(system(from, CoordDefinition::Grids(grids))?);
        }
        Ok(systems)
    }

    fn write(&self, card: Fields) -> Fields {
        match &self.definition {
            CoordDefinition::Points { rid, a, b, c } => {
                card.ints([self.id, *rid]).reals(&a.coords).reals(&b.coords).reals(&c.coords)
            }
            CoordDefinition::Grids(grids) => card.int(self.id).ints(*grids),
        }
    }

    fn raise(&mut self, by: Step) {
        by.cards(&mut self.id);
        match &mut self.definition {
            CoordDefinition::Points { rid, .. } => by.systems(rid),
            CoordDefinition::Grids(grids) => by.cards(grids),
        }
    }

    fn mirrored(self, mirror: &Mirror) -> Mirrored<Self> {
        let definition = match self.definition {
            CoordDefinition::Points { rid, a, b, c } => {
                let place = |xyz| mirror.place(rid, xyz, &self.span);
                CoordDefinition::Points { rid: 0, a: place(a)?, b: place(b)?, c: place(c)? }
            }
            grids @ CoordDefinition::Grids(_) => grids,
        };
        Ok(Some(Self { definition, ..self }))
    }
}
