//! What every file of cards needs.

pub(super) use super::kind::{
    DeckCard, Ids, Mirror, Mirrored, Step, flipped, keeps_numbers, keyed, minus, no_image, not_written,
    numbered, own_image, raises, variant,
};
pub(super) use crate::card::{Card, fields::Fields};
pub(super) use crate::source::{InputError, Span};
