//! `calibrate`: placeholder.

use crate::args::{CalibrateArgs, Common};
use crate::failure::Failure;

/// Runs the command.
pub(crate) fn run(_args: &CalibrateArgs, _common: &Common) -> Result<(), Failure> {
    Err(Failure::Computation("calibrate is not available yet".into()))
}
