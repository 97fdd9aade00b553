//! Measured loads as files have them: `flight.ron`, tables of points, histories.

pub mod file;
mod history;
mod points;

pub use file::{Channel, Condition, FlightFile, Source};
pub use points::{Reading, State, readings};
