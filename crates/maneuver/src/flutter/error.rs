//! What a stability analysis can refuse, and why it can fail.

use aero::AeroError;

/// Why no flutter or divergence speed can be given.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum FlutterError {
    /// The matrices do not fit each other.
    #[error("{what} has {rows} rows and {columns} columns, but there are {expected} generalised coordinates")]
    Size {
        /// Which matrix.
        what: &'static str,
        /// Its rows.
        rows: usize,
        /// Its columns.
        columns: usize,
        /// Generalised coordinates.
        expected: usize,
    },
    /// A number that is not finite, or out of its range.
    #[error("{what}: {value} is not {expected}")]
    Number {
        /// What it is.
        what: &'static str,
        /// What was given.
        value: f64,
        /// What was expected.
        expected: &'static str,
    },
    /// The frequencies of a table do not rise.
    #[error(
        "the frequencies of the table of generalised forces do not rise: {first} 1/m is followed by {second} 1/m"
    )]
    NotRising {
        /// A frequency omega/V, 1/m.
        first: f64,
        /// The next.
        second: f64,
    },
    /// A table with nothing in it.
    #[error("{0} is empty")]
    Empty(&'static str),
    /// A frequency that the table of generalised forces does not cover.
    #[error(
        "omega/V = {asked} 1/m is outside of the table of generalised forces, which covers {low} to {high} 1/m; \
         compute the table further"
    )]
    OutsideTable {
        /// What was asked for, 1/m.
        asked: f64,
        /// Least frequency of the table, 1/m.
        low: f64,
        /// Largest frequency of the table, 1/m.
        high: f64,
    },
    /// A mode was lost on its way from one airspeed to the next.
    #[error(
        "mode {mode} cannot be followed beyond {v_m_s} m/s (at {frequency_hz} Hz): no root near it has its shape"
    )]
    Lost {
        /// Number of the mode, from 1.
        mode: usize,
        /// Where it was last seen, m/s.
        v_m_s: f64,
        /// Its frequency there, Hz.
        frequency_hz: f64,
    },
    /// Eigenvalues that do not converge.
    #[error("the eigenvalues of {0} do not converge")]
    Eigenvalues(&'static str),
    /// The doublet lattice.
    #[error(transparent)]
    Aero(#[from] AeroError),
}
