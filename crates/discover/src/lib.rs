#![doc = include_str!("../README.md")]

pub mod data;
pub mod gate;
pub mod locate;
pub mod noise;
pub mod simulator;
pub mod transform;
