//! Trim and derivatives of a user's whole-aircraft deck (SOL 144), its flutter (SOL 145) and gusts (SOL 146).

mod box_rows;
pub mod cases;
pub mod flutter;
mod given_load;
pub mod grids;
pub mod gust;
pub mod inertia_relief;
mod mean_pitch;
pub mod modal;
mod monitors;
mod net_monitors;
pub mod nodal;
mod plate;
mod spline;
pub(crate) mod structure;
pub mod trim;
mod variables;
