//! The general element (GENEL): a stiffness or flexibility matrix between motions of grids.
//!
//! Its layout is its own: EID blank UI1 CI1 UI2 CI2 UI3 CI3 / UI4 CI4 ... / UD blank UD1 CD1 ... / K or Z and the
//! lower triangle column by column / S and the rigid motions row by row. Words start new lists wherever they stand.

use super::prelude::*;
use crate::motion::Motion;

/// A general element (GENEL).
#[derive(Debug, Clone, PartialEq)]
pub struct Genel {
    /// Identification number.
    pub id: u32,
    /// Motions the matrix belongs to.
    pub ui: Vec<Motion>,
    /// Motions of the support.
    pub ud: Vec<Motion>,
    /// True for a flexibility (Z), false for a stiffness (K).
    pub is_flexibility: bool,
    /// The matrix, square and symmetric, of the size of `ui`.
    pub matrix: Vec<Vec<f64>>,
    /// S: rigid motion of each of `ui` by each of `ud`; empty if not given.
    pub s: Vec<Vec<f64>>,
    /// Where the card stands.
    pub span: Span,
}

impl DeckCard for Genel {
    numbered!();
    /// A GENEL card.
    fn read(card: &Card) -> Result<Vec<Self>, InputError> {
        let id = card.id(0, "EID")?;
        let is_word = |index: &usize| {
            ["UD", "K", "Z", "S"].iter().any(|word| card.text(*index).eq_ignore_ascii_case(word))
        };
        let words: Vec<usize> = (1..card.len()).filter(is_word).collect();
        let list = |word: &str| -> Result<Option<(usize, usize)>, InputError> {
            let mut found = words.iter().filter(|index| card.text(**index).eq_ignore_ascii_case(word));
            let Some(&start) = found.next() else { return Ok(None) };
            if let Some(again) = found.next() {
                return Err(card.error(*again, format!("list {word} stands twice in GENEL {id}")));
            }
            let end = words.iter().copied().find(|index| *index > start).unwrap_or(card.len());
            Ok(Some((start + 1, end)))
        };
        let ui = motions(card, (1, words.first().copied().unwrap_or(card.len())), "UI", "CI")?;
        let ud = list("UD")?.map_or(Ok(Vec::new()), |range| motions(card, range, "UD", "CD"))?;
        if ui.is_empty() {
            return Err(card.error(2, format!("GENEL {id} has no motions in its list UI")));
        }
        if let Some((grid, digit)) = ui.iter().find(|motion| ud.contains(motion)) {
            let message =
                format!("motion {digit} of grid {grid} stands in both lists, UI and UD, of GENEL {id}");
            return Err(card.error(2, message));
        }
        let (is_flexibility, range) = match (list("Z")?, list("K")?) {
            (Some(range), None) => (true, range),
            (None, Some(range)) => (false, range),
            (Some(_), Some((k, _))) => {
                return Err(card.error(k - 1, format!("GENEL {id} has both K and Z; give one of them")));
            }
            (None, None) => return Err(card.error(0, format!("GENEL {id} has neither K nor Z"))),
        };
        let triangle =
            numbers(card, range, ui.len() * (ui.len() + 1) / 2, if is_flexibility { "Z" } else { "K" })?;
        let s = match list("S")? {
            None if !ud.is_empty() && ud.len() != 6 => {
                let message = format!(
                    "GENEL {id} has {} motions in UD and no S; without S there must be six",
                    ud.len()
                );
                return Err(card.error(0, message));
            }
            None => Vec::new(),
            Some(range) if ud.is_empty() => {
                return Err(card.error(range.0 - 1, format!("GENEL {id} has S but no motions in UD")));
            }
            Some(range) => numbers(card, range, ui.len() * ud.len(), "S")?
                .chunks(ud.len())
                .map(<[f64]>::to_vec)
                .collect(),
        };
        let matrix = square(&triangle, ui.len());
        Ok(vec![Genel { id, ui, ud, is_flexibility, matrix, s, span: card.span.clone() }])
    }

    fn write(&self, card: Fields) -> Fields {
        let mut card = card.int(self.id).blanks(1).motions(&self.ui).next_line();
        if !self.ud.is_empty() {
            card = card.text("UD").blanks(1).motions(&self.ud).next_line();
        }
        card = card.text(if self.is_flexibility { "Z" } else { "K" });
        for (column, values) in self.matrix.iter().enumerate() {
            // The matrix is symmetric: the lower part of a column is the right part of the row.
            card = card.reals(values.get(column..).unwrap_or(&[]));
        }
        if !self.s.is_empty() {
            card = self.s.iter().fold(card.next_line().text("S"), super::super::card::fields::Fields::reals);
        }
        card
    }

    raises!(cards: id, ui, ud);

    fn mirrored(self, _: &Mirror) -> Mirrored<Self> {
        let message = format!("GENEL {} cannot be mirrored", self.id);
        Err(InputError::at(&self.span, message).with_help("give the structure as elements"))
    }
}

/// Pairs of grid and component; empty fields between pairs are skipped.
fn motions(card: &Card, range: (usize, usize), grid: &str, digit: &str) -> Result<Vec<Motion>, InputError> {
    let mut motions = Vec::new();
    let mut index = range.0;
    while index < range.1 {
        if card.text(index).is_empty() {
            index += 1;
            continue;
        }
        let motion = card.motion(index, grid, digit)?;
        if motions.contains(&motion) {
            let message =
                format!("motion {} of grid {} stands twice in list {grid} of GENEL", motion.1, motion.0);
            return Err(card.error(index, message));
        }
        motions.push(motion);
        index += 2;
    }
    Ok(motions)
}

/// The numbers of a list, exactly `count`.
fn numbers(card: &Card, range: (usize, usize), count: usize, what: &str) -> Result<Vec<f64>, InputError> {
    let given = (range.0..range.1).filter(|index| !card.text(*index).is_empty());
    let values: Vec<f64> = given.map(|index| card.real(index, what)).collect::<Result<_, _>>()?;
    if values.len() == count {
        return Ok(values);
    }
    let message =
        format!("list {what} of GENEL {} has {} numbers; expected {count}", card.text(0), values.len());
    Err(card.error(range.0 - 1, message).with_help("K and Z list the lower triangle, S one row for each UI"))
}

/// The symmetric matrix of a lower triangle given column by column.
fn square(triangle: &[f64], size: usize) -> Vec<Vec<f64>> {
    let mut matrix = vec![vec![0.0; size]; size];
    let mut values = triangle.iter();
    for (row, column) in (0..size).flat_map(|column| (column..size).map(move |row| (row, column))) {
        let value = *values.next().expect("the triangle was counted");
        (matrix[row][column], matrix[column][row]) = (value, value);
    }
    matrix
}
