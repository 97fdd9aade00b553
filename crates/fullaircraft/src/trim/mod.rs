//! Steady flight: trims, steady maneuvers, loads at stations, derivatives and the V-n envelope.

pub(crate) mod balance;
pub mod case;
pub mod derivatives;
pub mod envelope;
pub mod large;
pub mod maneuvers;
pub mod model;
pub mod trimmed;
pub mod variables;
