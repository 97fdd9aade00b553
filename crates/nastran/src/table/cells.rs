//! Lines cut into cells, and cells read as numbers.

use crate::source::{InputError, Span};
use std::ops::Range;
use std::path::PathBuf;
use std::sync::Arc;

/// A cell's text without quotes and surrounding blanks, and where it stands.
#[derive(Debug, Clone)]
pub(super) struct Cell {
    pub(super) text: String,
    pub(super) span: Span,
}

/// What is between the cells of a table with this header.
pub(super) fn separator(header: &str) -> char {
    let mut quoted = false;
    let outside: Vec<char> = header
        .chars()
        .filter(|&character| {
            quoted ^= character == '"';
            !quoted
        })
        .collect();
    ['\t', ';'].into_iter().find(|separator| outside.contains(separator)).unwrap_or(',')
}

/// A line by which spreadsheets are told the separator (`sep=;`); the header tells it, too.
pub(super) fn is_separator_line(line: &str) -> bool {
    let line = line.trim_matches(['"', ' ', '\t']).to_ascii_lowercase();
    line.strip_prefix("sep=").is_some_and(|rest| rest.chars().count() <= 1)
}

/// A number; with `comma`, a comma is its decimal point.
pub(super) fn decimal(text: &str, comma: bool) -> Option<f64> {
    if comma { text.replacen(',', ".", 1).parse().ok() } else { text.parse().ok() }
}

/// A number with a comma as decimal point.
pub(super) fn is_decimal_comma(text: &str) -> bool {
    text.contains(',') && !text.contains('.') && decimal(text, true).is_some()
}

/// Cuts a line into cells; at least one.
pub(super) fn split(
    file: &Arc<PathBuf>,
    line: usize,
    text: &str,
    separator: char,
) -> Result<Vec<Cell>, InputError> {
    let characters: Vec<char> = text.chars().collect();
    let mut cells = Vec::new();
    let mut start = 0;
    let mut quoted = false;
    for position in 0..=characters.len() {
        let at_end = position == characters.len();
        if !at_end && characters[position] == '"' {
            quoted = !quoted;
        }
        if at_end || (characters[position] == separator && !quoted) {
            cells.push(cell(file, line, &characters, start..position));
            start = position + 1;
        }
    }
    if quoted {
        let last = &cells[cells.len() - 1].span;
        return Err(
            InputError::at(last, "a quoted cell does not end on its line").with_help("add the closing \"")
        );
    }
    Ok(cells)
}

fn cell(file: &Arc<PathBuf>, line: usize, characters: &[char], range: Range<usize>) -> Cell {
    let raw = &characters[range.clone()];
    let blanks = raw.iter().take_while(|c| c.is_whitespace()).count();
    let trimmed: String = raw.iter().collect::<String>().trim().to_owned();
    let column = if trimmed.is_empty() { range.start } else { range.start + blanks } + 1;
    let width = trimmed.chars().count().max(1);
    let text = match trimmed.strip_prefix('"').and_then(|rest| rest.strip_suffix('"')) {
        Some(inner) => inner.replace("\"\"", "\""),
        None => trimmed,
    };
    Cell { text, span: Span::new(file, line, column, column + width) }
}
