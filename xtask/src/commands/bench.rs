//! `bench`: placeholder.

use crate::args::{BenchArgs, Common};
use crate::failure::Failure;

/// Runs the command.
pub(crate) fn run(_args: &BenchArgs, _common: &Common) -> Result<(), Failure> {
    Err(Failure::Computation("bench is not available yet".into()))
}
