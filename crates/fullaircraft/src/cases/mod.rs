//! Grids of flight cases: their file, the cases flown and the load envelope of all.

mod check;
pub mod envelope;
pub mod file;
pub mod grid;
pub mod list;
