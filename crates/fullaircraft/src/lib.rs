#![doc = include_str!("../README.md")]

pub mod aircraft;
pub mod cases;
pub mod deck;
pub mod design_loads;
pub mod error;
pub mod flight;
pub mod model;
pub mod package;
pub mod results;
pub mod stations;
pub mod trim;

pub use aircraft::assembly::{Aircraft, WingPlaces};
pub use aircraft::file::{AircraftFile, FlightPoint, Surfaces};
pub use aircraft::lift_limits::LiftLimits;
pub use cases::file::CasesFile;
pub use cases::grid::{Case, CaseFlight, CaseResult};
pub use deck::cases::{DeckCase, deck_cases};
pub use deck::trim::{Elastic, TrimDeck, TrimmedDeck};
pub use error::AircraftError;
pub use flight::air::FlightAir;
pub use flight::drive::Drive;
pub use flight::gust::Gust;
pub use flight::history::FlightHistory;
pub use flight::loads::{FlightLoads, FlownLoads};
pub use flight::model::FlyingAircraft;
pub use flight::modes::FreeModes;
pub use flight::nonlinear::Integration;
pub use flight::small_motions::FreeFlight;
pub use results::comparison::{Comparison, Summary};
pub use stations::nodal::{Component, NodalLoads};
pub use stations::places::Station;
pub use trim::case::{Balanced, TrimAt, TrimCase, TrimTools};
pub use trim::derivatives::{Coefficients, Derivatives};
pub use trim::envelope::Envelope;
pub use trim::maneuvers::Steady;
pub use trim::model::{FlightModel, Trimmed};
