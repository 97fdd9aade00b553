//! Case control, as far as static aeroelasticity needs it: which TRIM, SPC, MPC and symmetry each SUBCASE selects.
//!
//! What stands before the first SUBCASE holds for all of them. Output requests and all other commands are skipped.

use crate::source::{InputError, Span};
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// What a subcase selects.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Subcase {
    /// Its number; zero for a deck without SUBCASE.
    pub id: u32,
    /// LABEL, else SUBTITLE.
    pub label: String,
    /// TRIM.
    pub trim: Option<u32>,
    /// SPC.
    pub spc: Option<u32>,
    /// MPC.
    pub mpc: Option<u32>,
    /// AESYMXZ: 1 symmetric, -1 antisymmetric, 0 asymmetric.
    pub symmetry: Option<i32>,
}

/// Reads the lines before BEGIN BULK.
///
/// # Errors
/// If a selection is no number, or AESYMXZ no symmetry.
pub(super) fn read(path: &Path, lines: &[&str]) -> Result<Vec<Subcase>, InputError> {
    let file: Arc<PathBuf> = Arc::new(path.to_path_buf());
    let mut common = Subcase::default();
    let mut subcases: Vec<Subcase> = Vec::new();
    for (at, line) in lines.iter().enumerate() {
        let text = line.split('$').next().unwrap_or("").trim();
        let wrong = |what: &str| {
            let span = Span::new(&file, at + 1, 1, line.chars().count().max(1) + 1);
            InputError::at(&span, format!("`{text}` selects nothing")).with_help(format!("expected {what}"))
        };
        let mut words = text.split(|c: char| c.is_whitespace() || c == '=').filter(|word| !word.is_empty());
        let (Some(command), value) = (words.next(), words.next()) else { continue };
        let number = || value.and_then(|value| value.parse::<u32>().ok()).ok_or_else(|| wrong("a number"));
        let command = command.to_ascii_uppercase();
        if command == "SUBCASE" {
            subcases.push(Subcase { id: number()?, ..common.clone() });
            continue;
        }
        let case = subcases.last_mut().unwrap_or(&mut common);
        match command.as_str() {
            "TRIM" => case.trim = Some(number()?),
            "SPC" => case.spc = Some(number()?),
            "MPC" => case.mpc = Some(number()?),
            "LABEL" | "SUBTITLE" => {
                case.label =
                    text.split_once('=').map_or_else(String::new, |(_, label)| label.trim().to_owned());
            }
            "AESYMXZ" => {
                let word = value.unwrap_or_default().to_ascii_uppercase();
                case.symmetry = Some(match word.get(..4) {
                    Some("SYMM") => 1,
                    Some("ANTI") => -1,
                    Some("ASYM") => 0,
                    _ => return Err(wrong("SYMMETRIC, ANTISYMMETRIC or ASYMMETRIC")),
                });
            }
            _ => {}
        }
    }
    if subcases.is_empty() && common.trim.is_some() {
        subcases.push(common);
    }
    Ok(subcases)
}
