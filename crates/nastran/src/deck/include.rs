//! INCLUDE: the file name, in quotes or not, also broken over several lines inside the quotes.

use crate::source::{InputError, Span};
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// What an INCLUDE statement asks for.
pub(crate) struct Target {
    /// The file name as given.
    pub(crate) path: PathBuf,
    /// Where the statement stands.
    pub(crate) span: Span,
    /// Index of the line after the statement.
    pub(crate) next_line: usize,
}

/// True if the line is an INCLUDE statement.
pub(crate) fn is_include(line: &str) -> bool {
    let word = line.trim_start().split(|c: char| c.is_whitespace() || "'\"=".contains(c)).next();
    word.is_some_and(|word| word.eq_ignore_ascii_case("INCLUDE"))
}

/// Reads the statement that starts in line `start`.
pub(crate) fn target(file: &Arc<PathBuf>, lines: &[&str], start: usize) -> Result<Target, InputError> {
    let line = lines[start];
    let rest = line.trim_start().get("INCLUDE".len()..).unwrap_or("").trim_start();
    let rest = rest.strip_prefix('=').unwrap_or(rest).trim();
    let span = Span::new(file, start + 1, 1, line.trim_end().chars().count() + 1);
    let mut next_line = start + 1;
    let name = match rest.chars().next() {
        Some(quote @ ('\'' | '"')) => {
            let mut name = rest[1..].to_owned();
            while !name.contains(quote) {
                let Some(more) = lines.get(next_line) else {
                    return Err(InputError::at(&span, "the quoted file name of INCLUDE does not end"));
                };
                name.push_str(more.trim());
                next_line += 1;
            }
            name.split(quote).next().unwrap_or("").to_owned()
        }
        _ => rest.split('$').next().unwrap_or("").trim().to_owned(),
    };
    if name.is_empty() {
        let error = InputError::at(&span, "INCLUDE without a file name");
        return Err(error.with_help("write INCLUDE 'file.bdf'"));
    }
    Ok(Target { path: PathBuf::from(name), span, next_line })
}

/// The same for every way to name the same file.
pub(crate) fn identity(path: &Path) -> PathBuf {
    std::fs::canonicalize(path).unwrap_or_else(|_| path.to_path_buf())
}
