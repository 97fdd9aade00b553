#![doc = include_str!("../README.md")]

mod aero_cards;
mod card;
pub mod cards;
mod counts;
pub mod deck;
pub mod dmi;
mod dmi_reader;
pub mod fe_cards;
mod field;
pub mod geometry;
mod include;
pub mod place;
mod property_cards;
pub mod real;
pub mod ron_file;
pub mod source;
mod structure_cards;
pub mod suggest;
pub mod table;
pub mod write;

pub use cards::*;
pub use deck::{parse_deck, read_deck};
pub use dmi::Dmi;
pub use fe_cards::*;
pub use geometry::Frames;
pub use place::{named_file, place_of};
pub use source::{InputError, Span, read_text};
pub use table::Table;
pub use write::write_deck;
