//! `fullaircraft`: placeholder.

use crate::args::{Common, FullaircraftArgs};
use crate::failure::Failure;

/// Runs the command.
pub(crate) fn run(_args: &FullaircraftArgs, _common: &Common) -> Result<(), Failure> {
    Err(Failure::Computation("fullaircraft is not available yet".into()))
}
