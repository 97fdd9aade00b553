//! Loads for a stress model: cards of cases, the structure they belong to, and the round trip that says that both are right.

pub mod cards;
pub mod condensed;
pub mod round_trip;
pub mod rows;
