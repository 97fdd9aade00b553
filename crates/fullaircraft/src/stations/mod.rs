//! Loads at stations: where loads are summed, and nodal loads of the g-set by what they come from.

pub mod along;
pub mod nodal;
pub mod places;
