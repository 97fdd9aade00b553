//! What is wrong with a section of a study, before anybody knows its file.

use nastran::InputError;
use std::path::Path;

/// A fault of a section.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Fault {
    /// The field, as [`InputError::in_field`] takes it.
    field: &'static str,
    message: String,
    help: Option<String>,
}

impl Fault {
    /// A fault of a field.
    pub(super) fn new(field: &'static str, message: impl Into<String>) -> Self {
        Self { field, message: message.into(), help: None }
    }

    /// The same with what to do.
    pub(super) fn with_help(self, help: impl Into<String>) -> Self {
        Self { help: Some(help.into()), ..self }
    }

    /// The error, at the field's line of the file.
    pub(super) fn of_file(self, path: &Path) -> InputError {
        let error = InputError::in_field(path, self.field, self.message);
        match self.help {
            Some(help) => error.with_help(help),
            None => error,
        }
    }
}

/// Whether a number is finite and above zero.
pub(super) fn is_above_zero(value: f64) -> bool {
    value > 0.0 && value.is_finite()
}
