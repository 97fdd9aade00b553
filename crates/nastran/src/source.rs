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
        Self { message: short(message.into()), span: Some(span.clone()), help: None }
    }

    /// An error about a file as a whole.
    pub fn in_file(file: &Path, message: impl Into<String>) -> Self {
        Self::at(&Span::whole_file(file), message)
    }

    /// An error without a place (a wrong combination of options, for instance).
    pub fn general(message: impl Into<String>) -> Self {
        Self { message: short(message.into()), span: None, help: None }
    }

    /// The same error, about a file if it has no place yet.
    #[must_use]
    pub fn or_in(self, file: &Path) -> Self {
        let span = self.span.or_else(|| Some(Span::whole_file(file)));
        Self { span, ..self }
    }

    /// The same error with a hint what to do.
    #[must_use]
    pub fn with_help(mut self, help: impl Into<String>) -> Self {
        self.help = Some(short(help.into()));
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

/// Longest word and longest sentence of a message, in characters: what is quoted from a file may be of any length.
const LONGEST: (usize, usize) = (120, 700);

/// A message with quotations that are too long cut in their middle.
fn short(message: String) -> String {
    let (word, sentence) = LONGEST;
    if message.len() <= word {
        return message;
    }
    let words: Vec<String> = message.split(' ').map(|text| cut(text, word)).collect();
    cut(&words.join(" "), sentence)
}

/// A text of at most so many characters (and three dots), its middle left out.
fn cut(text: &str, most: usize) -> String {
    let count = text.chars().count();
    if count <= most {
        return text.to_owned();
    }
    let (start, end) = (text.chars().take(most / 2), text.chars().skip(count - most / 2));
    start.chain("...".chars()).chain(end).collect()
}
