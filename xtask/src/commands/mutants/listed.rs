//! What cargo-mutants would change in a crate.

use std::process::Command;

use nastran::InputError;
use serde::Deserialize;
use wingroot::failure::Failure;

use crate::repository;

/// What is changed: the kinds of cargo-mutants that a switch can stand for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
pub(super) enum Genre {
    /// A function's body by a value.
    FnValue,
    /// An operator by another.
    BinaryOperator,
    /// An operator left out.
    UnaryOperator,
    /// An arm of a match left out.
    MatchArm,
    /// A guard by true or false.
    MatchArmGuard,
    /// No switch stands for it: a field left out of a struct's literal.
    #[serde(other)]
    Other,
}

/// A mutant as cargo-mutants lists it.
#[derive(Debug, Clone, PartialEq, Deserialize)]
pub(super) struct Mutant {
    /// What it says of it: file, place, change, function.
    pub(super) name: String,
    /// Source file from the repository's root.
    pub(super) file: String,
    /// What is changed.
    pub(super) genre: Genre,
    /// By what: an operator, a value, nothing.
    pub(super) replacement: String,
    span: Span,
}

#[derive(Debug, Clone, PartialEq, Deserialize)]
struct Span {
    start: Place,
}

/// Line and column, both from one.
#[derive(Debug, Clone, PartialEq, Deserialize)]
struct Place {
    line: usize,
    column: usize,
}

impl Mutant {
    /// Whether it is at a line and column, both counted from one.
    pub(super) fn begins_at(&self, line: usize, column: usize) -> bool {
        self.span.start == Place { line, column }
    }
}

/// All mutants of a crate, or of some of its files, but those that .cargo/mutants.toml names.
pub(super) fn listed(name: &str, files: &[&str]) -> Result<Vec<Mutant>, Failure> {
    let mut command = Command::new("cargo");
    command.current_dir(repository::path("."));
    command.args(["mutants", "--list", "--json", "--package", &format!("wingroot-{name}")]);
    for file in files {
        command.arg("--file").arg(format!("crates/{name}/src/{file}"));
    }
    let output = command.output().map_err(not_there)?;
    if output.status.success() {
        return read(&output.stdout);
    }
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    Err(if said.contains("no such command") { not_there(said) } else { Failure::Computation(said) })
}

/// The list that cargo-mutants prints.
pub(super) fn read(json: &[u8]) -> Result<Vec<Mutant>, Failure> {
    serde_json::from_slice(json)
        .map_err(|error| Failure::Computation(format!("the list of cargo-mutants: {error}")))
}

fn not_there(error: impl std::fmt::Display) -> Failure {
    let message =
        format!("cargo mutants cannot be started: {}", error.to_string().lines().next().unwrap_or_default());
    InputError::general(message).with_help("install it with `cargo install cargo-mutants --locked`").into()
}
