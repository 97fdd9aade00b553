#![doc = include_str!("../README.md")]

mod campaign;
mod check;
mod comparison;
mod curvature;
mod file;
mod noise;
mod polars;
mod readme;
mod run_file;
mod runs;
mod sections;
mod statics;
mod structure;
mod truth;

pub use calibrate::{Noise, Use};
pub use campaign::{Campaign, campaign};
pub use comparison::{AirspeedComparison, ChannelComparison, FlightState, HalfWingFlight, compare};
pub use file::{AirspeedSections, BeamChange, Blocks, Corners, Sections, Statics, TruthSettings, TunnelFile};
pub use readme::{Found, Story, readme};
pub use run_file::{Dynamics, Joiner, RunPlan};
pub use statics::StaticRow;
pub use truth::{TrueState, Truth, TunnelError};
