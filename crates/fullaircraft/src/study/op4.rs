//! Matrices of OP4 files (Nastran's OUTPUT4), in ASCII and binary, dense and as strings of what is not zero.
//!
//! A matrix is a head (columns, rows, form, type, name), a record a column (column, first row, length), and the record of a column
//! beyond the last. A first row of zero announces strings: each has its own head, `IS = row + 65536 (L + 1)` for L words of numbers, or,
//! in the form for many rows (BIGMAT), L + 1 and the row. A number has one word in single and two in double precision; ASCII files count
//! the numbers of a dense column, all others words.

mod binary;
mod records;
mod text;

use super::matrix::{MOST_TERMS, MassTerms};
use nastran::InputError;
use records::{Head, Records};
use std::fs::File;
use std::io::Read as _;
use std::path::Path;

/// Name of the matrix that is taken where there are several.
const MASS: &str = "MGG";

/// Row and column, counted from zero, and value.
type Term = (usize, usize, f64);

/// The mass matrix of a file: its only one, or MGG among several.
///
/// # Errors
/// If the file cannot be read or ends early, has no such matrix, or the matrix is not real and square.
pub(super) fn read(path: &Path) -> Result<MassTerms, InputError> {
    if is_binary(path) {
        chosen(path, &mut binary::Binary::open(path)?)
    } else {
        let text = nastran::read_text(path)?;
        chosen(path, &mut text::Text::new(path, &text))
    }
}

/// Whether a file begins with the length of a binary head.
fn is_binary(path: &Path) -> bool {
    let mut start = [0; 4];
    let is_file = path.metadata().is_ok_and(|about| about.is_file());
    is_file
        && File::open(path).and_then(|mut file| file.read_exact(&mut start)).is_ok()
        && binary::layout(start).is_some()
}

fn chosen(path: &Path, records: &mut dyn Records) -> Result<MassTerms, InputError> {
    let mut found: Option<(Head, Vec<Term>)> = None;
    let mut names = Vec::new();
    while let Some(head) = records.head()? {
        names.push(head.name.clone());
        let is_wanted = found.is_none() || head.name == MASS;
        let terms = terms(&head, is_wanted && head.fault().is_none(), records)?;
        if is_wanted {
            found = Some((head, terms));
        }
    }
    let Some((head, terms)) = found else {
        return Err(InputError::in_file(path, "there is no matrix in this OP4 file"));
    };
    if names.iter().filter(|name| *name == MASS).count() > 1 {
        let message = format!("there are several matrices called {MASS}: {}", names.join(", "));
        return Err(InputError::in_file(path, message).with_help("keep the mass matrix alone in the file"));
    }
    if names.len() > 1 && head.name != MASS {
        let message =
            format!("there are {} matrices, {}, and none is called {MASS}", names.len(), names.join(", "));
        return Err(InputError::in_file(path, message).with_help("keep the mass matrix alone in the file"));
    }
    if let Some(fault) = head.fault() {
        return Err(InputError::in_file(path, format!("{fault}, which is no mass matrix"))
            .with_help("expected a real square matrix, type 1 or 2 and form 1 or 6, with all of its terms"));
    }
    let count = usize::try_from(head.rows).unwrap_or(usize::MAX);
    Ok(MassTerms::Rows { count, terms })
}

/// The terms of a matrix that are not zero, if they are wanted.
fn terms(head: &Head, is_wanted: bool, records: &mut dyn Records) -> Result<Vec<Term>, InputError> {
    let [dense, string] = records.words_of_double().map(|double| head.words(double));
    let mut terms = Terms { head, is_wanted, all: Vec::new() };
    loop {
        let [column, row, length] = records.column()?;
        let strange =
            format!("a record of column {column} from row {row} with {length} words in {}", head.name);
        let (Ok(column), Ok(row), Ok(mut left)) =
            (u64::try_from(column), u64::try_from(row), u64::try_from(length))
        else {
            return Err(records.wrong(strange));
        };
        if column > head.columns {
            records.skip()?;
            return Ok(terms.all);
        }
        if column == 0 {
            return Err(records.wrong(strange));
        }
        if row > 0 {
            let values = records.reals(left / dense)?;
            terms.add(column, row, &values).map_err(|what| records.wrong(what))?;
            left = 0;
        }
        while left > 0 {
            let (head_words, words, row) = string_head(head, records)?;
            left = left
                .checked_sub(head_words + words)
                .ok_or_else(|| records.wrong(format!("a string of {words} words in {left} that are left")))?;
            let values = records.reals(words / string)?;
            terms.add(column, row, &values).map_err(|what| records.wrong(what))?;
        }
        records.end()?;
    }
}

/// Words of a string's head and of its numbers, and its first row.
fn string_head(head: &Head, records: &mut dyn Records) -> Result<(u64, u64, u64), InputError> {
    let (head_words, longer, row) = if head.is_big {
        let [longer, row] = records.whole(2)?;
        (2, longer, row)
    } else {
        let [both, _] = records.whole(1)?;
        (1, both >> 16, both & 0xFFFF)
    };
    match (u64::try_from(longer), u64::try_from(row)) {
        (Ok(longer), Ok(row)) if longer > 0 && row > 0 => Ok((head_words, longer - 1, row)),
        _ => Err(records.wrong(format!("a string of {longer} words from row {row}"))),
    }
}

/// Terms being collected.
struct Terms<'a> {
    head: &'a Head,
    is_wanted: bool,
    all: Vec<Term>,
}

impl Terms<'_> {
    /// Adds values below each other, places counted from one, or says why they cannot be there.
    fn add(&mut self, column: u64, row: u64, values: &[f64]) -> Result<(), String> {
        if !self.is_wanted {
            return Ok(());
        }
        let Head { rows, name, .. } = self.head;
        if row + values.len() as u64 - 1 > *rows {
            return Err(format!("{} numbers from row {row} on, and {name} has {rows} rows", values.len()));
        }
        let column = usize::try_from(column - 1).map_err(|error| error.to_string())?;
        let first = usize::try_from(row - 1).map_err(|error| error.to_string())?;
        let own = values.iter().enumerate().filter(|(_, value)| **value != 0.0);
        self.all.extend(own.map(|(i, value)| (first + i, column, *value)));
        if self.all.len() > MOST_TERMS {
            return Err(format!("{name} has more than {MOST_TERMS} terms that are not zero"));
        }
        Ok(())
    }
}
