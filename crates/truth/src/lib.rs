#![doc = include_str!("../README.md")]

pub mod air;
pub mod beam;
mod fault;
pub mod profile;
pub mod rig;
pub mod setting;
pub mod wing;

pub use fault::Fault;
