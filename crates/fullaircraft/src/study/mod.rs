//! What a deck lacks for trims, flutter or gusts: a file beside decks of structure and panels says where mass, splines, references,
//! support and what is asked for come from, and becomes a deck (SOL 144, 145 or 146) that wingroot and other programs run.
//!
//! So there is one way to run a deck, and what a study means can be read in cards.

mod cards;
mod fault;
mod file;
mod flutter;
mod flutter_cards;
mod formats;
mod gust_cards;
mod gusts;
mod matrix;
mod nearest;
mod op4;
mod text;
mod trim_cards;
mod trims;
mod unsteady;
mod unsteady_cards;

pub use file::{Aim, Masses, Reference, Splines, Study};
pub use flutter::{Densities, Flutter, Method};
pub use formats::read_terms;
pub use gusts::{Frequencies, Gusts, Times, Wave};
pub use matrix::MassTerms;
pub use text::Deck;
pub use trims::{Balance, Control, Point};
pub use unsteady::{Motion, Unsteady};
