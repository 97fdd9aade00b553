#![doc = include_str!("../README.md")]

pub mod air;
mod air_fit;
mod assemble;
pub mod deflection;
pub mod deflection_fit;
pub mod effects;
pub mod flutter;
pub mod growth;
pub mod gust;
pub mod history;
mod linear;
mod load_rows;
pub mod maneuver_file;
pub mod motion;
mod operators;
mod periodic;
pub mod rig;
pub mod rig_model;
pub mod rom;
pub mod run;
pub mod simulate;
#[cfg(test)]
mod small;
pub mod smoothing;
mod state_space;
pub mod step;
pub mod suspicion;

pub use air::{AirModel, SharedAir};
pub use air_fit::AirFit;
pub use deflection::{DeflectionAt, DeflectionCorrection, fly_commanded, simulate_commanded};
pub use history::{Channel, TimeHistory};
pub use load_rows::Station;
pub use maneuver_file::ManeuverFile;
pub use motion::Signal;
pub use rig::{Actuator, Rig, RigError, RigSettings};
pub use rig_model::{Inputs, Motion, RigModel};
pub use run::Run;
pub use simulate::{Simulated, motion_of, simulate};
pub use smoothing::{Smooth, smooth_from_rest, zero_phase};
pub use step::ExactStep;
