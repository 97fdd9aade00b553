#![doc = include_str!("../README.md")]

pub mod air;
pub mod beam;
pub mod campaign;
mod case;
mod draw;
pub mod drive;
pub mod effects;
mod fault;
pub mod lift;
mod order;
pub mod profile;
mod random;
mod recording;
pub mod rig;
pub mod setting;
mod signals;
pub mod wing;

pub use case::Tunnel;
pub use draw::{WINGS, true_wing};
pub use fault::Fault;
pub use order::Order;
