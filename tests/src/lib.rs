//! Our results beside published ones: the published cases with what computes them, and helpers of the tests.
//!
//! A case is a function from its file to [`Row`]s, registered in [`registry`]; both the named tests and
//! `cargo xtask validate` call it, so that the table is what the tests check.

pub mod cases;
pub mod fem;
pub mod fuzzing;
pub mod half_wing;
pub mod registry;
pub mod row;
pub mod theodorsen;

pub use registry::{Case, Outcome, check};
pub use row::{Row, Tolerance, Verdict};

use serde_json::Value;
use std::path::PathBuf;

/// A file below the repository's `data` folder.
pub fn data(relative: &str) -> PathBuf {
    PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/../data")).join(relative)
}

/// A published case: `data/published/NAME.json`.
///
/// # Panics
/// If the file is not there or is not JSON: the test's own fault.
pub fn published(name: &str) -> Value {
    let path = data(&format!("published/{name}.json"));
    let text = std::fs::read_to_string(&path).expect("a published case the test names is in data/published");
    serde_json::from_str(&text).expect("published cases are JSON")
}

/// A number of a case.
///
/// # Panics
/// If it is something else.
pub fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("{value} is not a number"))
}

/// A list of numbers of a case.
///
/// # Panics
/// If it is something else.
pub fn numbers(value: &Value) -> Vec<f64> {
    list(value).iter().map(number).collect()
}

/// A list of a case.
///
/// # Panics
/// If it is something else.
pub fn list(value: &Value) -> &[Value] {
    value.as_array().unwrap_or_else(|| panic!("{value} is not a list"))
}

/// `got` within `rel` of `want`, or within `abs`.
///
/// # Panics
/// If not, saying what it is about.
#[track_caller]
pub fn assert_close(what: &str, got: f64, want: f64, rel: f64, abs: f64) {
    let off = (got - want).abs();
    assert!(
        off <= abs + rel * want.abs(),
        "{what}: {got} instead of {want}, off by {:.3e}",
        off / want.abs()
    );
}
