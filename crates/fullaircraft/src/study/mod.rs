//! What a deck lacks for trims: a file beside decks of structure and panels says where mass, splines, references, support and trims
//! come from, and becomes a deck (SOL 144) that wingroot and other programs run.
//!
//! So there is one way to trim a deck, and what a study means can be read in cards.

mod cards;
mod file;
mod matrix;
mod nearest;
mod text;

pub use file::{Balance, Control, Masses, Point, Reference, Splines, Study};
pub use matrix::{MassTerms, read_terms};
pub use text::Deck;
