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
pub mod study;
pub mod trim;

pub use aircraft::assembly::{Aircraft, WingPlaces};
pub use aircraft::file::{AircraftFile, FlightPoint, Surfaces};
pub use aircraft::lift_limits::LiftLimits;
pub use cases::file::CasesFile;
pub use cases::grid::{CaseFlight, CaseResult};
pub use cases::list::Case;
pub use deck::cases::{DeckCase, DivergenceCase, deck_cases, deck_cases_beside_divergence, divergence_cases};
pub use deck::flutter::{FlutterDeck, FlutterPoints, FlutterRoots, flutter_cases};
pub use deck::gust::{
    DeckGust, DynamicAnswer, GustCase, GustDeck, GustLoads, MonitorAnswer, RandomAnswer, RandomSet,
    TimeAnswer, gust_cases,
};
pub use deck::inertia_relief::InertiaRelief;
pub use deck::modal::ModalDeck;
pub use deck::structure::clamped;
pub use deck::trim::{Elastic, TrimDeck, TrimmedDeck};
pub use error::AircraftError;
pub use flight::air::FlightAir;
pub use flight::drive::Drive;
pub use flight::gust::{Gust, GustAxis};
pub use flight::history::FlightHistory;
pub use flight::loads::{FlightLoads, FlownLoads};
pub use flight::model::FlyingAircraft;
pub use flight::modes::FreeModes;
pub use flight::nonlinear::Integration;
pub use flight::small_motions::FreeFlight;
pub use results::comparison::{Comparison, Flown, ModelNumbers, Summary};
pub use results::large::{BentNumbers, LargeFlight, LargePoint};
pub use stations::nodal::{Component, NodalLoads};
pub use stations::places::Station;
pub use trim::case::{Balanced, TrimAt, TrimCase, TrimTools};
pub use trim::derivatives::{Coefficients, Derivatives};
pub use trim::envelope::Envelope;
pub use trim::large::{LargeAircraft, LargeTrimmed};
pub use trim::maneuvers::Steady;
pub use trim::model::{FlightModel, Trimmed};
