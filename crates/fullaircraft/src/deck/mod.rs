//! Trim and derivatives of a user's whole-aircraft deck (SOL 144), and its flutter (SOL 145).

mod box_rows;
pub mod cases;
pub mod flutter;
pub mod grids;
mod monitors;
mod net_monitors;
pub mod nodal;
mod plate;
mod spline;
mod structure;
pub mod trim;
mod variables;
