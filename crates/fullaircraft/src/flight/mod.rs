//! The free, elastic aircraft in unsteady air: its modes, its air as a rational function, and flight in time.

pub mod air;
pub mod drive;
mod equations;
pub mod gust;
pub mod held;
pub mod history;
mod load_sources;
pub mod loads;
pub mod model;
pub mod modes;
pub mod nonlinear;
#[cfg(test)]
mod point_mass;
mod rows;
mod sensors;
#[cfg(test)]
mod small;
pub mod small_motions;
mod solved_air;
mod state;
pub mod turbulence;
