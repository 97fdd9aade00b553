#![doc = include_str!("../README.md")]

pub mod air;
pub mod beam;
pub mod campaign;
mod case;
mod draw;
pub mod drive;
pub mod effects;
mod fault;
pub mod profile;
mod random;
pub mod rig;
pub mod setting;
pub mod wing;

pub use case::{Order, Tunnel};
pub use draw::{WINGS, true_wing};
pub use fault::Fault;
