//! DMI cards in: headers and columns in any order, runs, repetition and explicit pairs.

use crate::card::Card;
use crate::dmi::Dmi;
use crate::real;
use crate::source::{InputError, Span};
use std::collections::{BTreeMap, BTreeSet};

/// The largest number of values of all matrices together: a slip in a header must not fill the memory.
const MOST_VALUES: usize = 25_000_000;
/// What a column takes beside its values, in values.
const A_COLUMN: usize = 8;

/// The DMI cards of a deck, until all are there.
#[derive(Debug, Default)]
pub(crate) struct DmiCards {
    headers: BTreeMap<String, (Dmi, usize, Span)>,
    columns: Vec<(String, usize, Card)>,
    /// Values of all headers so far.
    values: usize,
}

impl DmiCards {
    /// Keeps a header (DMI NAME 0 FORM TIN TOUT blank M N) or a column (DMI NAME J ...).
    pub(crate) fn add(&mut self, card: Card) -> Result<(), InputError> {
        let name = card.name_at(0, "NAME")?;
        let column = card.count_or(1, "J", 0)? as usize;
        if column > 0 {
            self.columns.push((name, column, card));
            return Ok(());
        }
        if let Some((_, _, first)) = self.headers.get(&name) {
            return Err(card.error(0, format!("DMI {name} has two headers; the first is {first}")));
        }
        let (matrix, columns) = header(&name, &card)?;
        self.values =
            self.values.saturating_add(columns.saturating_mul(matrix.rows.saturating_add(A_COLUMN)));
        if self.values > MOST_VALUES {
            return Err(card.error(
                6,
                format!(
                    "DMI {name} has {} x {columns} values; at most {MOST_VALUES} are read, all matrices together",
                    matrix.rows
                ),
            ));
        }
        self.headers.insert(name, (matrix, columns, card.span));
        Ok(())
    }

    /// Fills the columns in.
    pub(crate) fn assemble(self) -> Result<BTreeMap<String, Dmi>, InputError> {
        let mut matrices = BTreeMap::new();
        for (name, (mut matrix, columns, _)) in self.headers {
            matrix.columns = vec![vec![0.0; matrix.rows]; columns];
            matrices.insert(name, matrix);
        }
        let mut filled = BTreeSet::new();
        for (name, column, card) in self.columns {
            let Some(matrix) = matrices.get_mut(&name) else {
                return Err(card.error(0, format!("DMI {name} has columns but no header")).with_help(
                    "add the card with 0 in the third field: DMI NAME 0 FORM TIN TOUT blank M N",
                ));
            };
            let count = matrix.columns.len();
            let Some(values) = matrix.columns.get_mut(column - 1) else {
                return Err(card.error(
                    1,
                    format!("DMI {name} has {count} columns by its header; this is column {column}"),
                ));
            };
            fill(&card, values)?;
            if !filled.insert((name, column)) {
                return Err(card.error(1, format!("column {column} of this DMI is given twice")));
            }
        }
        Ok(matrices)
    }
}

fn header(name: &str, card: &Card) -> Result<(Dmi, usize), InputError> {
    let form = card.id(2, "FORM")?;
    if ![1, 2, 3, 6].contains(&form) {
        return Err(card.wrong(2, "FORM", "1 (square), 2 (rectangular), 3 (diagonal) or 6 (symmetric)"));
    }
    let tin = card.id(3, "TIN")?;
    if tin > 2 {
        return Err(card.wrong(3, "TIN", "1 or 2; only real matrices are read"));
    }
    let tout = card.count_or(4, "TOUT", 0)?;
    let rows = card.id(6, "M")? as usize;
    let columns = card.id(7, "N")? as usize;
    if form == 3 && columns != 1 {
        return Err(card.wrong(
            7,
            "N",
            "1, which a diagonal matrix (form 3) demands: its diagonal is one column",
        ));
    }
    if (form == 1 || form == 6) && columns != rows {
        return Err(card.wrong(7, "N", &format!("{rows}, the number of rows, which form {form} demands")));
    }
    Ok((Dmi { name: name.to_owned(), form, tin, tout, rows, columns: Vec::new() }, columns))
}

/// Row numbers are whole numbers, values have a decimal point, `THRU` repeats the value before it.
fn fill(card: &Card, values: &mut [f64]) -> Result<(), InputError> {
    // The row the next value belongs to, counted from one.
    let mut row: Option<usize> = None;
    // Rows up to here are filled, whichever way.
    let mut filled = 0;
    let mut last_value = None;
    let mut index = 2;
    while index < card.len() {
        let text = card.text(index);
        if text.eq_ignore_ascii_case("THRU") {
            let value = last_value
                .ok_or_else(|| card.error(index, "THRU repeats a value, but there is none before it"))?;
            index += 1;
            let end = row_number(card, index, values.len(), filled)?;
            values[filled..end].fill(value);
            (filled, row, last_value) = (end, None, None);
        } else if let Some(value) = real::parse(text) {
            let at = row.ok_or_else(|| card.error(index, "a value without a row number before it"))?;
            if at > values.len() {
                return Err(card.error(
                    index,
                    format!("a value for row {at}, but the matrix has {} rows", values.len()),
                ));
            }
            values[at - 1] = value;
            (filled, row, last_value) = (at, Some(at + 1), Some(value));
        } else if !text.is_empty() {
            row = Some(row_number(card, index, values.len(), filled)?);
            last_value = None;
        }
        index += 1;
    }
    Ok(())
}

fn row_number(card: &Card, index: usize, rows: usize, filled: usize) -> Result<usize, InputError> {
    let text = card.text(index);
    let Ok(row) = text.parse::<usize>() else {
        return Err(card
            .error(index, format!("`{text}` in a column of DMI is neither a row number nor a real number")));
    };
    if row > rows || row <= filled {
        let message =
            format!("row {row} does not fit: the matrix has {rows} rows and {filled} of them are passed");
        return Err(card
            .error(index, message)
            .with_help("rows must ascend; real numbers need a decimal point"));
    }
    Ok(row)
}
