#![doc = include_str!("../README.md")]

pub mod case;
pub mod divergence;
pub mod error;
pub mod exchange;
pub mod kept;
pub mod large;
pub mod load_rows;
pub mod nastran_deck;
pub mod planform;
pub mod readings;
pub mod root_loads;
pub mod shape;
pub mod spline;
pub mod steady;
pub mod supported;
pub mod suspicion;
pub mod wing;
pub mod wing_file;
mod wing_parts;

pub use case::{CorrectableBoxes, RootSensitivity, SteadyCase, SteadyModel};
pub use error::CouplingError;
pub use exchange::Exchange;
pub use kept::Keep;
pub use large::{
    BentMotion, BentMotionError, CarriedPart, FreeBody, FreeState, LargeModel, LargeState, LargeWing,
    SteadyFlight, Wake,
};
pub use load_rows::{Balance, root_rows, station_rows, strip_rows};
pub use nastran_deck::{DeckOptions, NastranDeck};
pub use readings::{Readings, Rows};
pub use root_loads::{ByLoad, Load, RootLoads};
pub use spline::Spline;
pub use steady::{SteadyOperator, SteadyState};
pub use supported::{RigidInertia, SupportedStructure};
pub use wing::{ElasticWing, GRAVITY_M_S2};
pub use wing_file::{Geometry, Mount, RootPlane, SplineKind, WingFile};
pub use wing_parts::{WingParts, spline_nodes};
