#![doc = include_str!("../README.md")]

pub mod air;
mod bench;
pub mod design;
pub mod effects;
pub mod flown;
mod jitter;
mod modal;
pub mod physics;
mod random;
mod separated;
pub mod separation;
mod servo;
mod simulate;
pub mod strips;
mod system;
mod truth_wing;

pub use bench::{Bench, Fineness};
pub use jitter::Jitter;
