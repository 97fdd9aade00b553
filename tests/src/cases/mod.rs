//! The published cases, a file for each family; every file has its `CASES`, which the registry lists.

pub mod divergence;
pub mod dlm;
pub mod flutter_decks;
pub mod flutter_plate;
pub mod flutter_strips;
pub mod flutter_wings;
pub mod gust_bah;
pub mod gusts;
pub mod laminates;
pub mod pagano;
pub mod plates;
pub mod shells;
pub mod solids;
pub mod trim;
pub mod unsteady2d;
pub mod vibrations;
pub mod vlm;
pub mod wings;
