#![doc = include_str!("../README.md")]

pub mod bulk_data;
mod card;
pub mod cards;
mod counts;
pub mod deck;
pub mod dmi;
pub mod geometry;
mod json_file;
pub mod memory;
mod mirror;
pub mod motion;
mod numbers;
pub mod op4;
pub mod place;
pub mod real;
pub mod ron_file;
pub mod ron_or_json;
pub mod source;
pub mod suggest;
pub mod table;
pub mod text_file;
mod unread;
pub mod write;

pub use bulk_data::{BulkData, CARD_KINDS, Unread};
pub use cards::*;
pub use deck::case_control::Subcase;
pub use deck::{parse_deck, read_deck};
pub use dmi::Dmi;
pub use geometry::Frames;
pub use motion::Motion;
pub use op4::op4_text;
pub use place::{named_file, place_of};
pub use source::{InputError, Span};
pub use table::Table;
pub use text_file::read_text;
pub use write::write_deck;
