#![doc = include_str!("../README.md")]

pub mod atmosphere;
mod cell;
mod check;
pub mod compare;
pub mod design;
pub mod flight;
pub mod matrix;
pub mod rules;
pub mod select;
pub mod tuning;
pub mod turbulence;
pub mod vn;

pub use atmosphere::Air;
pub use design::Design;
pub use flight::FlightFile;
pub use matrix::{Case, Condition, Matrix, matrix};
pub use rules::pratt::Airframe;
pub use rules::{Mark, Quantity};
pub use select::file::SelectFile;
pub use select::{Instant, Selection, select};
pub use vn::Diagram;
