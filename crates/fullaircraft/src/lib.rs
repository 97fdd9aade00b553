#![doc = include_str!("../README.md")]

pub mod aircraft;
mod aircraft_check;
pub mod aircraft_file;
mod beam;
pub mod cards;
mod closing;
mod deck_spline;
pub mod envelope;
pub mod error;
mod fe_mirror;
mod fe_numbers;
pub mod flight;
pub mod free_modes;
mod fuselage;
pub mod history;
pub mod mirror;
pub mod numbers;
pub mod results;
pub mod shape;
mod tail;
pub mod trim;
pub mod trim_deck;
mod trim_solve;
pub mod vtu;

pub use aircraft::{Aircraft, WingPlaces};
pub use aircraft_file::{AircraftFile, FlightPoint, Surfaces};
pub use envelope::{Envelope, LiftLimits};
pub use error::AircraftError;
pub use flight::FreeFlight;
pub use free_modes::FreeModes;
pub use history::FlightHistory;
pub use results::{Comparison, Summary};
pub use trim::{FlightModel, Trimmed};
pub use trim_deck::{Elastic, TrimDeck, TrimmedDeck};
