//! Deck (placeholder).
use crate::cards::BulkData;
use crate::source::{InputError, read_text};
use std::path::Path;
/// Reads a deck.
///
/// # Errors
/// If bad.
pub fn read_deck(path: &Path) -> Result<BulkData, InputError> {
    let _ = read_text(path)?;
    Ok(BulkData::default())
}
/// Parses a deck.
///
/// # Errors
/// If bad.
pub fn parse_deck(_name: &str, _text: &str) -> Result<BulkData, InputError> {
    Ok(BulkData::default())
}
