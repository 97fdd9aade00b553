//! Lifting panels: CAERO1, PAERO1 and the lists of numbers (AEFACT) that divide them.

use super::prelude::*;
use nalgebra::Point3;

/// Divisions of a panel: a number of equal ones, or the boundaries listed on an AEFACT.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Divisions {
    /// NSPAN or NCHORD.
    Equal(u32),
    /// LSPAN or LCHORD: identification of an AEFACT with fractions from 0 to 1.
    Aefact(u32),
}

impl Ids for Divisions {
    fn each(&mut self, change: &mut dyn FnMut(&mut u32)) {
        if let Self::Aefact(id) = self {
            change(id);
        }
    }
}

impl Divisions {
    /// The AEFACT, if one lists them.
    pub fn list(&self) -> Option<u32> {
        match self {
            Self::Aefact(id) => Some(*id),
            Self::Equal(_) => None,
        }
    }
}

/// A lifting panel (CAERO1).
#[derive(Debug, Clone, PartialEq)]
pub struct Caero1 {
    /// Identification number; boxes are numbered from it.
    pub id: u32,
    /// PAERO1.
    pub property: u32,
    /// Coordinate system of the points.
    pub cp: u32,
    /// Spanwise divisions.
    pub span_divisions: Divisions,
    /// Chordwise divisions.
    pub chord_divisions: Divisions,
    /// Interference group.
    pub group: u32,
    /// Leading edge at side 1.
    pub point_1: Point3<f64>,
    /// Chord at side 1, along x of the aerodynamic system.
    pub chord_1: f64,
    /// Leading edge at side 4.
    pub point_4: Point3<f64>,
    /// Chord at side 4.
    pub chord_4: f64,
    /// Where the card stands.
    pub span: Span,
}

impl DeckCard for Caero1 {
    numbered!();
    /// CAERO1: EID PID CP NSPAN NCHORD LSPAN LCHORD IGID / X1 Y1 Z1 X12 X4 Y4 Z4 X43.
    fn read(card: &Card) -> Result<Vec<Self>, InputError> {
        let chord = |index: usize, name: &str| -> Result<f64, InputError> {
            let value = card.real_or(index, name, 0.0)?;
            if value < 0.0 { Err(card.wrong(index, name, "a chord, zero or more")) } else { Ok(value) }
        };
        Ok(vec![Caero1 {
            id: card.id(0, "EID")?,
            property: card.id(1, "PID")?,
            cp: card.count_or(2, "CP", 0)?,
            span_divisions: divisions(card, 3, ["NSPAN", "LSPAN"])?,
            chord_divisions: divisions(card, 4, ["NCHORD", "LCHORD"])?,
            group: card.count_or(7, "IGID", 1)?,
            point_1: card.vector(8, ["X1", "Y1", "Z1"])?,
            chord_1: chord(11, "X12")?,
            point_4: card.vector(12, ["X4", "Y4", "Z4"])?,
            chord_4: chord(15, "X43")?,
            span: card.span.clone(),
        }])
    }

    fn write(&self, card: Fields) -> Fields {
        let (span, chord) = (&self.span_divisions, &self.chord_divisions);
        let number = |divisions: &Divisions| match divisions {
            Divisions::Equal(number) => Some(*number),
            Divisions::Aefact(_) => None,
        };
        let card =
            card.ints([self.id, self.property, self.cp]).optional(number(span)).optional(number(chord));
        let card = card.optional(span.list()).optional(chord.list()).int(self.group);
        card.reals(&self.point_1.coords).real(self.chord_1).reals(&self.point_4.coords).real(self.chord_4)
    }

    raises!(boxes: id; cards: property, span_divisions, chord_divisions; systems: cp);

    /// Panels still run from left to right, so normals stay up and side 1 is the image of side 4.
    fn mirrored(self, mirror: &Mirror) -> Mirrored<Self> {
        Ok(Some(Self {
            cp: 0,
            point_1: mirror.place(self.cp, self.point_4, &self.span)?,
            chord_1: self.chord_4,
            point_4: mirror.place(self.cp, self.point_1, &self.span)?,
            chord_4: self.chord_1,
            ..self
        }))
    }
}

/// A count in field `at`, or the list two fields behind it.
fn divisions(card: &Card, at: usize, [count, list]: [&str; 2]) -> Result<Divisions, InputError> {
    match (card.count_or(at, count, 0)?, card.count_or(at + 2, list, 0)?) {
        (0, 0) => Err(card.empty(at, count, &format!("a number, here or an AEFACT in {list}"))),
        (0, aefact) => Ok(Divisions::Aefact(aefact)),
        (number, 0) => Ok(Divisions::Equal(number)),
        _ => Err(card.error(at + 2, format!("CAERO1 has both {count} and {list}; give one of them"))),
    }
}

/// A panel's property (PAERO1); its bodies are not read.
#[derive(Debug, Clone, PartialEq)]
pub struct Paero1 {
    /// Identification number.
    pub id: u32,
    /// Where the card stands.
    pub span: Span,
}

impl DeckCard for Paero1 {
    numbered!();
    /// PAERO1: PID B1 B2 ...
    fn read(card: &Card) -> Result<Vec<Self>, InputError> {
        Ok(vec![Self { id: card.id(0, "PID")?, span: card.span.clone() }])
    }

    fn write(&self, card: Fields) -> Fields {
        card.int(self.id)
    }

    raises!(cards: id);

    own_image!();
}

/// A list of numbers (AEFACT), in the card's order.
#[derive(Debug, Clone, PartialEq)]
pub struct Aefact {
    /// Identification number.
    pub id: u32,
    /// The numbers.
    pub values: Vec<f64>,
    /// Where the card stands.
    pub span: Span,
}

impl DeckCard for Aefact {
    numbered!();
    /// AEFACT: SID D1 D2 ...
    fn read(card: &Card) -> Result<Vec<Self>, InputError> {
        let values = (1..card.len().max(2)).map(|index| card.real(index, "D")).collect::<Result<_, _>>()?;
        Ok(vec![Aefact { id: card.id(0, "SID")?, values, span: card.span.clone() }])
    }

    fn write(&self, card: Fields) -> Fields {
        card.int(self.id).reals(&self.values)
    }

    raises!(cards: id);

    /// Those of strips count from the other side.
    fn mirrored(mut self, mirror: &Mirror) -> Mirrored<Self> {
        if mirror.strips.contains(&self.id) {
            self.values = self.values.iter().rev().map(|fraction| 1.0 - fraction).collect();
        }
        Ok(Some(self))
    }
}
