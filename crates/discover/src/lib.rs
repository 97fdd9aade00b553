#![doc = include_str!("../README.md")]

pub mod data;
pub mod noise;
pub mod simulator;
pub mod transform;
