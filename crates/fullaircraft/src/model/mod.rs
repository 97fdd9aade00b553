//! The cards of the whole aircraft: right wing, its image, tail, fuselage and the ties between them.

pub(crate) mod beam;
pub mod cards;
pub(crate) mod closing;
pub(crate) mod fuselage;
pub mod mirror;
#[cfg(test)]
mod small;
pub(crate) mod tail;
