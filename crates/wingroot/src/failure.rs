//! How a command can fail, and the exit status that follows.

use nastran::InputError;

/// Why a command did not end well.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Failure {
    /// The input or the usage is wrong: exit status 2.
    Input(InputError),
    /// The computation could not be completed (divergence, no convergence): exit status 3.
    Computation(String),
}

impl Failure {
    /// The exit status of the process.
    pub fn exit_status(&self) -> u8 {
        match self {
            Self::Input(_) => 2,
            Self::Computation(_) => 3,
        }
    }

    /// A failed computation from any error's own words.
    pub fn computation(error: impl std::fmt::Display) -> Self {
        Self::Computation(error.to_string())
    }
}

impl From<InputError> for Failure {
    fn from(error: InputError) -> Self {
        Self::Input(error)
    }
}

impl std::fmt::Display for Failure {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Input(error) => error.fmt(f),
            Self::Computation(message) => f.write_str(message),
        }
    }
}

impl std::error::Error for Failure {}
