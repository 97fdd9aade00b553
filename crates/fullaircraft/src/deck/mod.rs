//! Trim and derivatives of a user's whole-aircraft deck (SOL 144).

mod box_rows;
pub mod cases;
mod monitors;
mod net_monitors;
mod plate;
mod spline;
mod structure;
pub mod trim;
mod variables;
