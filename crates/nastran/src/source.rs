//! Where something stands in an input file, and the one error for bad input.
//!
//! Used for decks, and also for the CSV and RON files of the other crates, so that every complaint names its
//! file, line and column in the same way.

use std::fmt;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// A place in an input file: one-based line and columns, `end_column` exclusive.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct Span {
    /// The file as the user named it.
    pub file: Arc<PathBuf>,
    /// Line, counted from one; zero if the whole file is meant.
    pub line: usize,
    /// First column, counted from one; zero if the whole line is meant.
    pub column: usize,
    /// One past the last column.
    pub end_column: usize,
}

impl Span {
    /// The place `line:column..end_column` of `file`.
    pub fn new(file: &Arc<PathBuf>, line: usize, column: usize, end_column: usize) -> Self {
        Self { file: Arc::clone(file), line, column, end_column }
    }

    /// The whole of a file.
    pub fn whole_file(file: &Path) -> Self {
        Self { file: Arc::new(file.to_path_buf()), line: 0, column: 0, end_column: 0 }
    }

    /// A place for things that come from no file, such as the cards of a parametric wing.
    pub fn generated(by: &str) -> Self {
        Self::whole_file(Path::new(by))
    }
}

impl fmt::Display for Span {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.file.display())?;
        if self.line > 0 {
            write!(f, ":{}", self.line)?;
            if self.column > 0 {
                write!(f, ":{}", self.column)?;
            }
        }
        Ok(())
    }
}

/// Bad input: one sentence that says what is wrong, where, and what to do about it.
///
/// `Display` prints `file:line:column: message`; the hint is separate so that a terminal can set it apart.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct InputError {
    /// What is wrong and what was expected, without a final full stop.
    pub message: String,
    /// Where, if a place is known.
    pub span: Option<Span>,
    /// What to do.
    pub help: Option<String>,
}

impl InputError {
    /// An error at a known place.
    pub fn at(span: &Span, message: impl Into<String>) -> Self {
        Self { message: message.into(), span: Some(span.clone()), help: None }
    }

    /// An error about a file as a whole.
    pub fn in_file(file: &Path, message: impl Into<String>) -> Self {
        Self::at(&Span::whole_file(file), message)
    }

    /// An error without a place (a wrong combination of options, for instance).
    pub fn general(message: impl Into<String>) -> Self {
        Self { message: message.into(), span: None, help: None }
    }

    /// The same error with a hint what to do.
    #[must_use]
    pub fn with_help(mut self, help: impl Into<String>) -> Self {
        self.help = Some(help.into());
        self
    }
}

impl fmt::Display for InputError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(span) = &self.span {
            write!(f, "{span}: ")?;
        }
        write!(f, "{}", self.message)?;
        if let Some(help) = &self.help {
            write!(f, " (hint: {help})")?;
        }
        Ok(())
    }
}

impl std::error::Error for InputError {}

/// Reads a text file, or says which file could not be read and why.
///
/// A byte order mark at the start is dropped.
///
/// # Errors
/// If the file is missing, unreadable or not UTF-8; the latter with the line.
pub fn read_text(path: &Path) -> Result<String, InputError> {
    let bytes = std::fs::read(path).map_err(|error| match error.kind() {
        std::io::ErrorKind::NotFound => InputError::in_file(path, "the file does not exist")
            .with_help("check the path; relative paths start from the folder the command runs in"),
        _ if path.is_dir() => InputError::in_file(path, "this is a folder; expected a text file")
            .with_help("name the file in it"),
        _ => InputError::in_file(path, format!("the file cannot be read: {error}"))
            .with_help("it must be a text file (UTF-8) that you may read"),
    })?;
    decode(path, bytes)
}

/// The text of a file's bytes.
fn decode(path: &Path, bytes: Vec<u8>) -> Result<String, InputError> {
    if bytes.starts_with(&[0xFF, 0xFE]) || bytes.starts_with(&[0xFE, 0xFF]) {
        return Err(InputError::in_file(path, "the file is in UTF-16; expected UTF-8 or plain ASCII")
            .with_help("save it again as UTF-8"));
    }
    let text = String::from_utf8(bytes).map_err(|error| {
        let good = error.utf8_error().valid_up_to();
        let before = String::from_utf8_lossy(&error.as_bytes()[..good]).into_owned();
        let line = before.matches('\n').count() + 1;
        let column = before.rsplit('\n').next().unwrap_or("").chars().count() + 1;
        let place = Span::new(&Arc::new(path.to_path_buf()), line, column, column + 1);
        let message = format!("byte {:#04X} is not UTF-8", error.as_bytes()[good]);
        InputError::at(&place, message).with_help(
            "save the file as UTF-8; letters such as umlauts in an older encoding are the usual cause",
        )
    })?;
    if let Some(at) = text.find('\0') {
        let line = text[..at].matches('\n').count() + 1;
        let place = Span::new(&Arc::new(path.to_path_buf()), line, 0, 0);
        return Err(InputError::at(&place, "the file has zero bytes, so it is no text file in UTF-8")
            .with_help("UTF-16 without a mark at its start is a usual cause; save it again as UTF-8"));
    }
    Ok(text.strip_prefix('\u{FEFF}').map(str::to_owned).unwrap_or(text))
}
