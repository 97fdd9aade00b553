#![doc = include_str!("../README.md")]

pub mod analysis;
pub mod bank;
pub mod candidate;
mod channels;
mod conditions;
pub mod consistency;
pub mod data;
pub mod directions;
mod distinguish;
pub mod gap;
pub mod gate;
pub mod level;
pub mod locate;
pub mod next;
pub mod noise;
pub mod numerics;
pub mod problem;
mod revise;
pub mod search;
pub mod shared;
pub mod simulator;
mod tolerance;
pub mod tones;
pub mod transform;
mod trial;
pub mod uncertain;
pub mod weigh;
