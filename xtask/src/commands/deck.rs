//! `deck`: placeholder
use crate::args::{Common, DeckArgs};
use crate::failure::Failure;
pub(crate) fn run(_args: &DeckArgs, _common: &Common) -> Result<(), Failure> {
    Err(Failure::computation("not yet"))
}
