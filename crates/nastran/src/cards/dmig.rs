//! Matrices by motions of points (DMIG): what K2GG and M2GG add to the structure, what K2PP, M2PP and B2PP add beside it.
//!
//! They are read, not written, and have no mirror image.

use super::prelude::*;
use crate::motion::Motion;

/// Fields of a column before its first term, and fields of a term: grid, component, real and imaginary part.
const FIRST_TERM: usize = 4;

/// A card of a matrix: its head, or terms of a column.
#[derive(Debug, Clone, PartialEq)]
pub struct Dmig {
    /// NAME.
    pub name: String,
    /// IFO and TIN of a head; nothing for a column.
    pub head: Option<DmigHead>,
    /// The column's motion; none for a head.
    pub column: Vec<Motion>,
    /// Motions of the column's terms.
    pub rows: Vec<Motion>,
    /// Real parts of its terms.
    pub values: Vec<f64>,
    /// Where the card stands.
    pub span: Span,
}

/// What the head of a matrix says of it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct DmigHead {
    /// IFO is 6: terms of one triangle stand for both.
    pub is_symmetric: bool,
    /// TIN is 3 or 4.
    pub is_complex: bool,
}

impl Dmig {
    /// All points that the card names.
    pub fn points(&self) -> impl Iterator<Item = u32> {
        self.column.iter().chain(&self.rows).map(|(point, _)| *point)
    }
}

impl DeckCard for Dmig {
    keyed!(String, name);
    /// DMIG: NAME 0 IFO TIN TOUT ..., then NAME GJ CJ blank G1 C1 A1 B1 / G2 C2 A2 B2 ...
    fn read(card: &Card) -> Result<Vec<Self>, InputError> {
        let (name, span) = (card.name_at(0, "NAME")?, card.span.clone());
        if card.text(1) == "0" {
            let (form, kind) = (card.count_or(2, "IFO", 1)?, card.count_or(3, "TIN", 1)?);
            let head = DmigHead { is_symmetric: form == 6, is_complex: kind > 2 };
            let [column, rows] = [Vec::new(), Vec::new()];
            return Ok(vec![Self { name, head: Some(head), column, rows, values: Vec::new(), span }]);
        }
        let column = vec![card.motion(1, "GJ", "CJ")?];
        let (mut rows, mut values) = (Vec::new(), Vec::new());
        for at in (FIRST_TERM..card.len()).step_by(4).filter(|at| !card.text(*at).is_empty()) {
            rows.push(card.motion(at, "G", "C")?);
            values.push(card.real_or(at + 2, "A", 0.0)?);
        }
        Ok(vec![Self { name, head: None, column, rows, values, span }])
    }

    not_written!();

    raises!(cards: column, rows);

    no_image!();
}
