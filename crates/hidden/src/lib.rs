#![doc = include_str!("../README.md")]

pub mod air;
pub mod answer;
mod at_speed;
mod bench;
pub mod campaign;
mod case;
mod changed;
mod class;
mod decimate;
pub mod design;
mod detect;
pub mod effects;
mod faults;
pub mod flown;
#[cfg(test)]
mod independent;
mod jitter;
mod modal;
mod noise;
mod outputs;
pub mod physics;
pub mod plan;
mod random;
pub mod score;
mod separated;
pub mod separation;
mod servo;
mod simulate;
mod sizes;
pub mod strips;
mod system;
mod truth_wing;
mod vortices;

pub use answer::Answer;
pub use bench::{Bench, Fineness};
pub use campaign::CampaignFiles;
pub use case::Case;
pub use class::{Class, Mix};
pub use jitter::Jitter;
pub use plan::{CasePlan, Defect, SeedRange, TrueServos, cases};
pub use score::{Families, Metrics, score};
