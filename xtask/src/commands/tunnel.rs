//! `tunnel`: placeholder.

use crate::args::{Common, TunnelArgs};
use crate::failure::Failure;

/// Runs the command.
pub(crate) fn run(_args: &TunnelArgs, _common: &Common) -> Result<(), Failure> {
    Err(Failure::Computation("tunnel is not available yet".into()))
}
