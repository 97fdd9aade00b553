//! Concentrated masses: CONM1 and CONM2.

use super::prelude::*;
use nalgebra::Vector3;

/// A concentrated mass (CONM2).
#[derive(Debug, Clone, PartialEq)]
pub struct Conm2 {
    /// Identification number.
    pub id: u32,
    /// Grid.
    pub grid: u32,
    /// Coordinate system of offset and inertia; -1 means the offset is a point in the basic system.
    pub cid: i32,
    /// Mass.
    pub mass: f64,
    /// Offset from the grid to the centre of gravity.
    pub offset: Vector3<f64>,
    /// I11, I21, I22, I31, I32, I33 about the centre of gravity.
    pub inertia: [f64; 6],
    /// Where the card stands.
    pub span: Span,
}

impl DeckCard for Conm2 {
    numbered!();
    /// CONM2: EID G CID M X1 X2 X3 blank / I11 I21 I22 I31 I32 I33. What is blank is zero, the mass too (inertia alone).
    fn read(card: &Card) -> Result<Vec<Self>, InputError> {
        let cid = card.integer_or(2, "CID", 0)?;
        if cid < -1 {
            return Err(card.wrong(2, "CID", "-1, 0 or a coordinate system"));
        }
        let mut inertia = [0.0; 6];
        for (index, name) in ["I11", "I21", "I22", "I31", "I32", "I33"].into_iter().enumerate() {
            inertia[index] = card.real_or(8 + index, name, 0.0)?;
        }
        Ok(vec![Conm2 {
            id: card.id(0, "EID")?,
            grid: card.id(1, "G")?,
            cid,
            mass: card.real_or(3, "M", 0.0)?,
            offset: card.vector(4, ["X1", "X2", "X3"])?,
            inertia,
            span: card.span.clone(),
        }])
    }

    fn write(&self, card: Fields) -> Fields {
        let card = card.ints([self.id, self.grid]).text(self.cid.to_string()).real(self.mass);
        card.reals(&self.offset).blanks(1).reals(&self.inertia)
    }

    raises!(cards: id, grid; systems: cid);

    fn mirrored(self, _: &Mirror) -> Mirrored<Self> {
        if self.cid > 0 {
            let message =
                format!("CONM2 {} has coordinate system {}, so it cannot be mirrored", self.id, self.cid);
            return Err(
                InputError::at(&self.span, message).with_help("set field CID of the wing's masses to 0")
            );
        }
        let [i11, i21, i22, i31, i32, i33] = self.inertia;
        let inertia = [i11, minus(i21), i22, i31, minus(i32), i33];
        Ok(Some(Self { offset: flipped(self.offset), inertia, ..self }))
    }
}

/// A mass given as a 6 x 6 matrix (CONM1).
#[derive(Debug, Clone, PartialEq)]
pub struct Conm1 {
    /// Identification number.
    pub id: u32,
    /// Grid.
    pub grid: u32,
    /// Coordinate system of the matrix; 0 is basic.
    pub cid: u32,
    /// The matrix, symmetric.
    pub mass: [[f64; 6]; 6],
    /// Where the card stands.
    pub span: Span,
}

impl DeckCard for Conm1 {
    numbered!();
    /// CONM1: EID G CID M11 M21 M22 M31 M32 / M33 M41 ... M66, the lower triangle row by row.
    fn read(card: &Card) -> Result<Vec<Self>, InputError> {
        card.ends_after(24)?;
        let mut mass = [[0.0; 6]; 6];
        let lower = (0..6).flat_map(|row| (0..=row).map(move |column| (row, column)));
        for (index, (row, column)) in (3..).zip(lower) {
            let value = card.real_or(index, &format!("M{}{}", row + 1, column + 1), 0.0)?;
            (mass[row][column], mass[column][row]) = (value, value);
        }
        Ok(vec![Conm1 {
            id: card.id(0, "EID")?,
            grid: card.id(1, "G")?,
            cid: card.count_or(2, "CID", 0)?,
            mass,
            span: card.span.clone(),
        }])
    }

    fn write(&self, card: Fields) -> Fields {
        let card = card.ints([self.id, self.grid, self.cid]);
        self.mass.iter().enumerate().fold(card, |card, (row, values)| card.reals(&values[..=row]))
    }

    raises!(cards: id, grid; systems: cid);

    fn mirrored(mut self, _: &Mirror) -> Mirrored<Self> {
        let sign = |at: usize| if matches!(at, 0 | 2 | 4) { 1.0 } else { -1.0 };
        for (i, row) in self.mass.iter_mut().enumerate() {
            for (j, value) in row.iter_mut().enumerate() {
                *value *= sign(i) * sign(j);
            }
        }
        Ok(Some(self))
    }
}
