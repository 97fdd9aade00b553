//! Grids of flight cases: their file, the cases flown and the load envelope of all.

pub mod envelope;
pub mod file;
pub mod grid;
