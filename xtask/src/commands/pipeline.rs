//! `pipeline`: placeholder.

use crate::args::{Common, PipelineArgs};
use crate::failure::Failure;

/// Runs the command.
pub(crate) fn run(_args: &PipelineArgs, _common: &Common) -> Result<(), Failure> {
    Err(Failure::Computation("pipeline is not available yet".into()))
}
