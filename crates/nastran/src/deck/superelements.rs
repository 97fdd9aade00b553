//! Superelements, which are not read: one sentence for every way in which a deck has them.

use super::include;
use crate::source::{InputError, Span};
use crate::text_file::read_deck_text;
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Cards that divide a model into superelements, attach them or say how they are reduced.
const CARDS: [&str; 25] = [
    "CSUPER", "CSUPEXT", "EXTRN", "RELEASE", "SEBNDRY", "SEBSET", "SEBSET1", "SEBULK", "SECONCT", "SECSET",
    "SECSET1", "SEELT", "SEEXCLD", "SELABEL", "SELOAD", "SELOC", "SEMPLN", "SENQSET", "SEQSET", "SEQSET1",
    "SESET", "SESUP", "SETREE", "SEUSET", "SEUSET1",
];

/// How every refusal ends.
const NOT_READ: &str = "superelements and parts are not read";

/// The refusal of what begins a part of the deck or makes one of it.
pub(super) fn refusal(span: &Span, what: &str) -> InputError {
    InputError::at(span, format!("{what}; {NOT_READ}"))
        .with_help("give the whole model as one bulk data section")
}

/// Refuses a card of superelements by its name.
pub(super) fn refuse(name: &str, span: &Span) -> Result<(), InputError> {
    if CARDS.contains(&name) {
        return Err(refusal(span, &format!("{name} makes this a deck of superelements")));
    }
    Ok(())
}

/// An error of a deck, or the reason for it if there are superelements anywhere: the parts of such a deck share numbers and refer
/// to points that only Nastran makes.
pub(super) fn explain(error: InputError, path: &Path, lines: &[&str], from: usize) -> InputError {
    if error.message.ends_with(NOT_READ) {
        return error;
    }
    found(path, lines, from, &mut BTreeSet::new()).err().unwrap_or(error)
}

/// Fails at the first card of superelements from a line on, also of included files; what cannot be read has been said before.
fn found(path: &Path, lines: &[&str], from: usize, seen: &mut BTreeSet<PathBuf>) -> Result<(), InputError> {
    if !seen.insert(include::identity(path)) {
        return Ok(());
    }
    let file = Arc::new(path.to_path_buf());
    let mut at = from;
    while at < lines.len() {
        let line = lines[at];
        at += 1;
        if include::is_include(line) {
            let Ok(target) = include::target(&file, lines, at - 1) else { continue };
            at = target.next_line;
            let inner = path.parent().unwrap_or(Path::new("")).join(&target.path);
            if let Ok(text) = read_deck_text(&inner) {
                found(&inner, &text.lines().collect::<Vec<_>>(), 0, seen)?;
            }
            continue;
        }
        let name = line.split(|c: char| c.is_whitespace() || ",*$".contains(c)).next().unwrap_or("");
        refuse(&name.to_uppercase(), &Span::new(&file, at, 1, name.chars().count() + 1))?;
    }
    Ok(())
}
