#![doc = include_str!("../README.md")]

pub mod cards;
pub mod deck;
pub mod dmi;
pub mod field;
pub mod geometry;
pub mod real;
pub mod ron_file;
pub mod source;
pub mod suggest;
pub mod table;

pub use cards::*;
pub use deck::{parse_deck, read_deck};
pub use dmi::Dmi;
pub use geometry::Frames;
pub use source::{InputError, Span, read_text};
pub use table::Table;
