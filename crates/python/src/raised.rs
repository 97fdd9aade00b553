//! Failures as the exceptions of `wingroot._errors`.

use pyo3::prelude::*;
use wingroot::failure::Failure;
use wingroot::nastran::InputError;

/// The exception for a failure: `InputError` with its place and hint, or `ComputationError`.
pub(crate) fn raised(py: Python<'_>, failure: &Failure) -> PyErr {
    let exception = py.import("wingroot._errors").and_then(|errors| match failure {
        Failure::Input(InputError { message, span, help }) => {
            let place = span.as_ref().map(|span| (span.file.display().to_string(), span.line, span.column));
            errors.getattr("InputError")?.call1((message, place, help.as_deref()))
        }
        Failure::Computation(message) => errors.getattr("ComputationError")?.call1((message,)),
    });
    exception.map_or_else(|error| error, PyErr::from_value)
}

/// The same for whatever becomes a failure.
pub(crate) fn checked<T>(py: Python<'_>, result: Result<T, impl Into<Failure>>) -> PyResult<T> {
    result.map_err(|error| raised(py, &error.into()))
}
