//! Where simulation and measurements disagree.

pub mod maneuver;

pub use maneuver::Maneuver;
