//! placeholder
use crate::args::{Common, ModesArgs};
use crate::failure::Failure;
pub(super) fn run(_args: &ModesArgs, _measured: &std::path::Path, _common: &Common) -> Result<(), Failure> {
    Err(Failure::computation("not yet"))
}
