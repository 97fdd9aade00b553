//! Loads at grids and scalar points: FORCE and MOMENT in fixed directions, FORCE1 and MOMENT1 along a line between grids, FORCE2 and MOMENT2
//! across two lines, SLOAD.

use super::prelude::*;
use nalgebra::Vector3;

/// A force or moment in a fixed direction (FORCE, MOMENT).
#[derive(Debug, Clone, PartialEq)]
pub struct PointLoad {
    /// Load set.
    pub set: u32,
    /// Grid it acts on.
    pub grid: u32,
    /// Coordinate system of the vector.
    pub cid: u32,
    /// Scale times vector.
    pub vector: Vector3<f64>,
    /// MOMENT.
    pub is_moment: bool,
    /// Where the card stands.
    pub span: Span,
}

impl DeckCard for PointLoad {
    keyed!(u32, set);
    variant!(|card| usize::from(card.is_moment));
    /// FORCE: SID G CID F N1 N2 N3.
    fn read(card: &Card) -> Result<Vec<Self>, InputError> {
        card.ends_after(7)?;
        Ok(vec![Self {
            set: card.id(0, "SID")?,
            grid: card.id(1, "G")?,
            cid: card.count_or(2, "CID", 0)?,
            vector: card.vector::<Vector3<f64>>(4, ["N1", "N2", "N3"])? * card.real(3, "F")?,
            is_moment: card.name == "MOMENT",
            span: card.span.clone(),
        }])
    }

    fn write(&self, card: Fields) -> Fields {
        card.ints([self.set, self.grid, self.cid]).real(1.0).reals(&self.vector)
    }

    // Sets keep their numbers.
    raises!(cards: grid; systems: cid);

    // An image has no case control that selects loads.
    no_image!();
}

/// A load on a scalar point (SLOAD).
#[derive(Debug, Clone, PartialEq)]
pub struct ScalarLoad {
    /// Load set.
    pub set: u32,
    /// Scalar point it acts on.
    pub point: u32,
    /// Size.
    pub size: f64,
    /// Where the card stands.
    pub span: Span,
}

impl DeckCard for ScalarLoad {
    keyed!(u32, set);
    /// SLOAD: SID S1 F1 S2 F2 S3 F3.
    fn read(card: &Card) -> Result<Vec<Self>, InputError> {
        card.ends_after(7)?;
        let set = card.id(0, "SID")?;
        let mut loads = Vec::new();
        for at in [1, 3, 5] {
            if at == 1 || !card.text(at).is_empty() || !card.text(at + 1).is_empty() {
                let (point, size) = (card.id(at, "S")?, card.real(at + 1, "F")?);
                loads.push(Self { set, point, size, span: card.span.clone() });
            }
        }
        Ok(loads)
    }

    fn write(&self, card: Fields) -> Fields {
        card.ints([self.set, self.point]).real(self.size)
    }

    // Sets keep their numbers.
    raises!(cards: point);

    // An image has no case control that selects loads.
    no_image!();
}

/// A force along, or a moment about, the line from one grid to another, which it follows (FORCE1, MOMENT1).
#[derive(Debug, Clone, PartialEq)]
pub struct LineLoad {
    /// Load set.
    pub set: u32,
    /// Grid it acts on.
    pub grid: u32,
    /// Size.
    pub size: f64,
    /// The line's ends.
    pub line: [u32; 2],
    /// MOMENT1.
    pub is_moment: bool,
    /// Where the card stands.
    pub span: Span,
}

impl DeckCard for LineLoad {
    keyed!(u32, set);
    variant!(|card| usize::from(card.is_moment));
    /// FORCE1: SID G F G1 G2.
    fn read(card: &Card) -> Result<Vec<Self>, InputError> {
        card.ends_after(5)?;
        let ends = card.corners(3, &["G1", "G2"])?;
        Ok(vec![Self {
            set: card.id(0, "SID")?,
            grid: card.id(1, "G")?,
            size: card.real(2, "F")?,
            line: [ends[0], ends[1]],
            is_moment: card.name == "MOMENT1",
            span: card.span.clone(),
        }])
    }

    fn write(&self, card: Fields) -> Fields {
        card.ints([self.set, self.grid]).real(self.size).ints(self.line)
    }

    // Sets keep their numbers.
    raises!(cards: grid, line);

    // An image has no case control that selects loads.
    no_image!();
}

/// A force, or a moment, normal to two lines between grids, which it follows (FORCE2, MOMENT2).
#[derive(Debug, Clone, PartialEq)]
pub struct CrossLoad {
    /// Load set.
    pub set: u32,
    /// Grid it acts on.
    pub grid: u32,
    /// Size.
    pub size: f64,
    /// Ends of the first line, then of the second; the direction is first cross second.
    pub ends: [u32; 4],
    /// MOMENT2.
    pub is_moment: bool,
    /// Where the card stands.
    pub span: Span,
}

impl DeckCard for CrossLoad {
    keyed!(u32, set);
    variant!(|card| usize::from(card.is_moment));
    /// FORCE2: SID G F G1 G2 G3 G4.
    fn read(card: &Card) -> Result<Vec<Self>, InputError> {
        card.ends_after(7)?;
        let ends = ["G1", "G2", "G3", "G4"].into_iter().enumerate();
        let ends = ends.map(|(at, name)| card.id(3 + at, name)).collect::<Result<Vec<u32>, _>>()?;
        Ok(vec![Self {
            set: card.id(0, "SID")?,
            grid: card.id(1, "G")?,
            size: card.real(2, "F")?,
            ends: [ends[0], ends[1], ends[2], ends[3]],
            is_moment: card.name == "MOMENT2",
            span: card.span.clone(),
        }])
    }

    fn write(&self, card: Fields) -> Fields {
        card.ints([self.set, self.grid]).real(self.size).ints(self.ends)
    }

    // Sets keep their numbers.
    raises!(cards: grid, ends);

    // An image has no case control that selects loads.
    no_image!();
}
