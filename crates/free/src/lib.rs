#![doc = include_str!("../README.md")]

pub mod air;
pub mod balance;
pub mod campaign;
pub mod cycles;
pub mod effect;
pub mod fit;
pub mod held_out;
pub mod least_squares;
pub mod motion;
pub mod points;
pub mod predict;
pub mod rig;
pub mod search;
pub mod section;
pub mod verdict;
pub mod window;
