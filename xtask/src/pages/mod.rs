//! The heads of the reports of developers' commands.

pub(crate) mod bench;
pub(crate) mod validate;
