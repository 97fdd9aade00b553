//! `simulate`: placeholder.

use crate::args::{Common, SimulateArgs};
use crate::failure::Failure;

/// Runs the command.
pub(crate) fn run(_args: &SimulateArgs, _common: &Common) -> Result<(), Failure> {
    Err(Failure::Computation("simulate is not available yet".into()))
}
