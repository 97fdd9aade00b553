#![doc = include_str!("../README.md")]

mod assemble;
pub mod flutter;
pub mod gust;
pub mod history;
mod operators;
pub mod rig;
pub mod rig_model;
pub mod run;
pub mod signals;
pub mod simulate;
pub mod smoothing;
pub mod step;

pub use history::{Channel, TimeHistory};
pub use rig::{Actuator, Rig, RigError, RigSettings};
pub use rig_model::{Inputs, Motion, RigModel};
pub use run::Run;
pub use signals::Signal;
pub use simulate::{Simulated, motion_of, simulate};
pub use smoothing::{Smooth, smooth_from_rest, zero_phase};
pub use step::ExactStep;
