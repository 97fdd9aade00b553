//! What can be wrong with data, terms and designs: each fault names the factor, term or block, and what to do.

use nastran::{InputError, Table};
use thiserror::Error;

/// Why there is no answer.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum Fault {
    /// A term cannot be read.
    #[error("the term `{term}` cannot be read: {why}; write it like `alpha^2*q` or `n^2/q`")]
    WrongTerm {
        /// As written.
        term: String,
        /// What is wrong with it.
        why: String,
    },
    /// A factor, response or block is not in the data.
    #[error("there is no {what} `{name}`; there are {known}")]
    Unknown {
        /// Factor, response or block.
        what: &'static str,
        /// The name asked for.
        name: String,
        /// The names there are.
        known: String,
    },
    /// Columns of unequal length.
    #[error("`{name}` has {found} values, the first column has {expected}")]
    Length {
        /// The column.
        name: String,
        /// Its values.
        found: usize,
        /// Those of the first column.
        expected: usize,
    },
    /// A name that is used twice or cannot stand in a term.
    #[error("`{name}` cannot be the name of a column: {why}")]
    Name {
        /// The name.
        name: String,
        /// Why not.
        why: &'static str,
    },
    /// A value that is not finite.
    #[error("point {point} of `{name}` is {value}, not a finite number")]
    NotFinite {
        /// Column or term.
        name: String,
        /// Point, from 1.
        point: usize,
        /// The value.
        value: f64,
    },
    /// A factor with one value.
    #[error(
        "the factor `{name}` is {value} at all points, so nothing can be said about it; take it out or vary it"
    )]
    ConstantFactor {
        /// The factor.
        name: String,
        /// Its value.
        value: f64,
    },
    /// A response with one value.
    #[error("the response `{name}` is {value} at all points, so there is nothing to fit")]
    ConstantResponse {
        /// The response.
        name: String,
        /// Its value.
        value: f64,
    },
    /// Terms that the points cannot tell apart.
    #[error("the term `{term}` cannot be told from {others} at these points; take one out or add points")]
    Aliased {
        /// The term.
        term: String,
        /// Terms of which it is a combination.
        others: String,
    },
    /// Not enough points.
    #[error("{points} points are too few for {terms} terms{needs}; take terms out or add points")]
    TooFewPoints {
        /// Points.
        points: usize,
        /// Terms, block offsets included.
        terms: usize,
        /// What for, such as ` and an error estimate`.
        needs: &'static str,
    },
    /// No replicates.
    #[error("there is no pure error: {why}; repeat points of {factors}")]
    NoReplicates {
        /// Why.
        why: String,
        /// The factors.
        factors: String,
    },
    /// A block column that cannot be used.
    #[error("the block `{name}` cannot be used: {why}")]
    Block {
        /// The column.
        name: String,
        /// Why not.
        why: String,
    },
    /// A number outside its range.
    #[error("{what} is {value}; expected {expected}")]
    Number {
        /// What.
        what: &'static str,
        /// Its value.
        value: f64,
        /// What is possible.
        expected: &'static str,
    },
    /// A design that does not hang together.
    #[error("the design is not possible: {why}")]
    Design {
        /// Why.
        why: String,
    },
}

impl Fault {
    /// Nothing of this name: the fault lists the names there are.
    pub(crate) fn unknown<'a>(
        what: &'static str,
        name: &str,
        known: impl IntoIterator<Item = &'a str>,
    ) -> Self {
        Self::Unknown { what, name: name.to_string(), known: list(known) }
    }

    /// Demands of a number that it is in its range: the fault names what it is, its value and what is expected.
    pub(crate) fn unless(
        is_good: bool,
        what: &'static str,
        value: f64,
        expected: &'static str,
    ) -> Result<(), Self> {
        if is_good { Ok(()) } else { Err(Self::Number { what, value, expected }) }
    }

    /// The fault at its cell or column of the table that the data come from, or at the table as a whole.
    pub fn in_table(&self, table: &Table) -> InputError {
        let (row, column) = match self {
            Self::ConstantFactor { name, .. }
            | Self::ConstantResponse { name, .. }
            | Self::Name { name, .. }
            | Self::Block { name, .. } => (0, name.as_str()),
            // of a term: at its last factor, where what is divided by stands
            Self::NotFinite { name, point, .. } => {
                let factors = name.split(['*', '/', '^']);
                (point - 1, factors.rev().map(str::trim).find(|name| table.has(name)).unwrap_or(""))
            }
            _ => (0, ""),
        };
        InputError::at(&table.span(row, column), self.to_string())
    }
}

impl From<Fault> for InputError {
    fn from(fault: Fault) -> Self {
        Self::general(fault.to_string())
    }
}

/// Names for a message: `a`, `b`.
pub(crate) fn list<'a>(names: impl IntoIterator<Item = &'a str>) -> String {
    let quoted: Vec<String> = names.into_iter().map(|name| format!("`{name}`")).collect();
    if quoted.is_empty() { "none".to_string() } else { quoted.join(", ") }
}
