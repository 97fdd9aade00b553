//! Everything an aircraft flies with both models, in numbers, and its deformed shapes.

pub mod comparison;
pub mod large;
pub mod shape;
