//! Where a deck's bulk data begin, and what is wrong with one whose BEGIN BULK is not there.

use crate::source::{InputError, Span};
use crate::suggest::distance;
use std::path::Path;
use std::sync::Arc;

/// The index of the line after BEGIN BULK; zero if the deck is bulk data alone.
///
/// # Errors
/// If BEGIN BULK is misspelt, or missing behind an executive or case control.
pub(super) fn start_of_bulk(path: &Path, lines: &[&str]) -> Result<usize, InputError> {
    if let Some(index) = lines.iter().position(|line| is_begin_bulk(line)) {
        return Ok(index + 1);
    }
    let at = |index: usize, message: String| {
        let file = Arc::new(path.to_path_buf());
        let end = lines[index].trim_end().chars().count() + 1;
        InputError::at(&Span::new(&file, index + 1, 1, end), message)
    };
    if let Some(index) = lines.iter().position(|line| is_nearly_begin_bulk(line)) {
        let message =
            format!("`{}` is not BEGIN BULK, which the deck has nowhere", said(lines[index]).trim());
        return Err(at(index, message).with_help("write BEGIN BULK"));
    }
    let with = |word: &str| lines.iter().position(|line| begins_with(line, word));
    with("CEND").or_else(|| with("SOL")).map_or(Ok(0), |index| {
        let message = "the deck has an executive or case control, but no BEGIN BULK";
        Err(at(index, message.to_owned()).with_help("write BEGIN BULK in a line before the first card"))
    })
}

/// A line without its comment.
fn said(line: &str) -> &str {
    line.split('$').next().unwrap_or("")
}

fn begins_with(line: &str, word: &str) -> bool {
    let first = said(line).trim_start().split(|c: char| c.is_whitespace() || ",=".contains(c)).next();
    first.is_some_and(|first| first.eq_ignore_ascii_case(word))
}

fn is_begin_bulk(line: &str) -> bool {
    let mut words = said(line).split_whitespace();
    words.next().is_some_and(|word| word.eq_ignore_ascii_case("BEGIN"))
        && words.next().is_some_and(|word| word.eq_ignore_ascii_case("BULK"))
}

/// Whether a line is BEGIN BULK but for two letters or its blank.
fn is_nearly_begin_bulk(line: &str) -> bool {
    const MEANT: &str = "BEGIN BULK";
    const SLIPS: usize = 2;
    let text = said(line).trim();
    text.len() <= MEANT.len() + SLIPS && distance(text, MEANT) <= SLIPS
}

/// A line of the case control if it is a PARAM, else an empty one.
pub(super) fn parameter_in(line: &str) -> &str {
    let text = line.trim_start();
    let is_parameter = text.get(..5).is_some_and(|word| word.eq_ignore_ascii_case("PARAM"))
        && text[5..].starts_with([',', ' ', '\t', '*']);
    // Only fixed fields stand where they stand.
    let line = if text.contains(',') { text } else { line };
    if is_parameter { line } else { "" }
}

/// Whether the NASTRAN statements before the bulk data give bars twisting inertia: BARMASS, by its name or the number of its cell.
pub(super) fn bars_twist(lines: &[&str]) -> bool {
    let cell = |line: &&str| -> Option<f64> {
        let line = said(line).to_ascii_uppercase();
        let words: Vec<&str> = line
            .split(|c: char| c.is_whitespace() || ",=".contains(c))
            .filter(|word| !word.is_empty())
            .collect();
        let cell = words.windows(2).rfind(|pair| ["BARMASS", "SYSTEM(398)"].contains(&pair[0]));
        cell.and_then(|pair| pair[1].parse().ok())
    };
    let statements = lines.iter().filter(|line| begins_with(line, "NASTRAN"));
    statements.filter_map(cell).next_back().is_some_and(|value| value > 0.0)
}
