//! One row: a command, what is changed of the example, and what must be said.

use std::fmt;

/// What a row must end with.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum End {
    /// Exit status 2: wrong usage or bad input.
    Refused,
    /// Exit status 3: the computation cannot be completed.
    Stopped,
    /// A number that some wings have: refused well, stopped well, or taken.
    Open,
}

/// What is done to a file of the example.
#[derive(Debug, Clone)]
pub(crate) enum Change {
    /// The first such text is another.
    Text(String, String),
    /// From the byte on, a text is another: the same text may stand elsewhere.
    At(usize, String, String),
    /// The whole file.
    Whole(Vec<u8>),
    /// The file is not there.
    Gone,
    /// A folder in its place.
    Folder,
}

/// A row.
#[derive(Debug, Clone)]
pub(crate) struct Row {
    /// The command line.
    pub(crate) command: String,
    /// The file that is changed; empty if none is.
    pub(crate) file: String,
    pub(crate) change: Change,
    pub(crate) end: End,
    /// What the message must contain.
    pub(crate) words: Vec<String>,
}

impl Row {
    /// A row that is refused.
    pub(crate) fn refused(command: &str, file: &str, change: Change, words: &[&str]) -> Self {
        let words = words.iter().map(|word| (*word).to_owned()).collect();
        Self { command: command.to_owned(), file: file.to_owned(), change, end: End::Refused, words }
    }

    /// The same with another end.
    pub(crate) fn ending(self, end: End) -> Self {
        Self { end, ..self }
    }
}

/// A text of a file that is another.
pub(crate) fn text(from: &str, to: &str) -> Change {
    Change::Text(from.to_owned(), to.to_owned())
}

/// Another file.
pub(crate) fn whole(content: impl Into<Vec<u8>>) -> Change {
    Change::Whole(content.into())
}

impl fmt::Display for Row {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let short = |text: &str| match text.char_indices().nth(60) {
            Some((end, _)) => format!("{}... ({} bytes)", text[..end].replace('\n', "\\n"), text.len()),
            None => text.replace('\n', "\\n"),
        };
        write!(f, "`{}`", self.command)?;
        match &self.change {
            Change::Text(from, to) => write!(f, " {}: {} -> {}", self.file, short(from), short(to)),
            Change::At(at, from, to) => write!(f, " {} at {at}: {} -> {}", self.file, short(from), short(to)),
            Change::Whole(bytes) if self.file.is_empty() && bytes.is_empty() => Ok(()),
            Change::Whole(bytes) => write!(f, " {} = {}", self.file, short(&String::from_utf8_lossy(bytes))),
            Change::Gone => write!(f, " {} is gone", self.file),
            Change::Folder => write!(f, " {} is a folder", self.file),
        }
    }
}
