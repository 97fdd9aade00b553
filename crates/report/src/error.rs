//! Why a picture could not be drawn.

use std::fmt;

/// Data that no picture can be drawn from.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum DrawError {
    /// There is nothing to draw: no panel, no series or no finite value in the named thing.
    Empty(String),
    /// Two lists that belong together have different lengths.
    Lengths {
        /// The series or view.
        what: String,
        /// Length of the first list (x, or corners).
        first: usize,
        /// Length of the second list (y, or values).
        second: usize,
    },
    /// The pixels could not be painted, in the painter's words.
    Pixels(String),
}

impl DrawError {
    /// Demands that two lists of the named thing are equally long.
    pub(crate) fn check_lengths(what: &str, first: usize, second: usize) -> Result<(), Self> {
        if first == second { Ok(()) } else { Err(Self::Lengths { what: what.to_owned(), first, second }) }
    }
}

impl fmt::Display for DrawError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Empty(what) => write!(f, "nothing to draw: {what} has no finite value"),
            Self::Pixels(why) => write!(f, "the picture cannot be painted: {why}"),
            Self::Lengths { what, first, second } => {
                write!(f, "'{what}' cannot be drawn: {first} places but {second} values")
            }
        }
    }
}

impl std::error::Error for DrawError {}
