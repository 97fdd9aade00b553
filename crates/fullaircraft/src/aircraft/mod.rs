//! The aircraft as its file describes it and as it is assembled for computing.

pub mod assembly;
mod check;
pub mod file;
pub mod lift_limits;
#[cfg(test)]
pub(crate) mod small;
