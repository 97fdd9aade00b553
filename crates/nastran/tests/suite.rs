//! The tests of `nastran` that need no process of their own, as one program: linked once, and both cores busy to the end.

mod broken_decks;
mod cards;
mod common;
mod complaints;
mod direct_matrices;
mod dmi;
mod every_kind;
mod fe_cards;
mod fields;
mod flutter_cards;
mod geometry;
mod gust_cards;
mod include;
mod json_files;
mod memory;
mod op4;
mod robustness;
mod ron_files;
mod round_trip;
mod sections;
mod tables;
mod text_files;
mod trim_cards;
mod unread_cards;
mod users_decks;
mod write;
