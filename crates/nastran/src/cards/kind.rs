//! What a deck asks of every card, and the tables it keeps the cards of one kind in.
//!
//! A new card is one file with its type and [`DeckCard`] for it, a field in [`crate::BulkData`] and a line in its list
//! of kinds; nothing compiles until all of them are there.

use crate::card::Card;
use crate::card::fields::Fields;
use crate::source::{InputError, Span};
use nalgebra::{Point3, Vector3};
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Display;

/// A card, as the deck reads, writes, numbers and mirrors it. What could be forgotten has no default.
pub(crate) trait DeckCard: Sized {
    /// What it is found by: a number or a name.
    type Key: Ord + Display;
    /// Its number or name.
    fn key(&self) -> Self::Key;
    /// Its number, if it has one.
    fn number(&self) -> Option<u32> {
        None
    }
    /// Gives it another number, if it has one.
    fn renumber(&mut self, _: u32) {}
    /// Where it stands.
    fn span(&self) -> &Span;
    /// Which of its kind's names ([`CardKind::names`]) it is written under.
    fn variant(&self) -> usize {
        0
    }
    /// The items of one card, whose name is one of its kind's.
    fn read(card: &Card) -> Result<Vec<Self>, InputError>;
    /// Adds its fields; a card that gets none is not written.
    fn write(&self, card: Fields) -> Fields;
    /// Raises its number and those it refers to.
    fn raise(&mut self, by: Step);
    /// Its image about y = 0, numbers kept; nothing if an image has no such card.
    fn mirrored(self, mirror: &Mirror) -> Mirrored<Self>;
}

/// The image of a card, nothing, or why there is none.
pub(crate) type Mirrored<C> = Result<Option<C>, InputError>;

/// Found by a field.
macro_rules! keyed {
    ($key:ty, $field:ident) => {
        type Key = $key;
        fn key(&self) -> $key {
            self.$field.clone()
        }
        fn span(&self) -> &Span {
            &self.span
        }
    };
}

/// Found by its own number, `id`.
macro_rules! numbered {
    () => {
        keyed!(u32, id);
        fn number(&self) -> Option<u32> {
            Some(self.id)
        }
        fn renumber(&mut self, id: u32) {
            self.id = id;
        }
    };
}

/// Of variants of a kind this is the one: an expression of the card.
macro_rules! variant {
    (|$card:ident| $variant:expr) => {
        fn variant(&self) -> usize {
            let $card = self;
            $variant
        }
    };
}

/// Raises the numbers in fields, by what they are numbers of: `cards`, `systems` or `boxes`.
macro_rules! raises {
    ($($what:ident: $($field:ident),*);*) => {
        fn raise(&mut self, by: Step) {
            $($(by.$what(&mut self.$field);)*)*
        }
    };
}

/// Sets keep their numbers, and so does what has none.
macro_rules! keeps_numbers {
    () => {
        fn raise(&mut self, _: Step) {}
    };
}

/// Nothing on it has a left or right.
macro_rules! own_image {
    () => {
        fn mirrored(self, _: &Mirror) -> Mirrored<Self> {
            Ok(Some(self))
        }
    };
}

/// An image has no such card.
macro_rules! no_image {
    () => {
        fn mirrored(self, _: &Mirror) -> Mirrored<Self> {
            Ok(None)
        }
    };
}

/// A card that is read only.
macro_rules! not_written {
    () => {
        fn write(&self, card: Fields) -> Fields {
            card
        }
    };
}

pub(super) use {keeps_numbers, keyed, no_image, not_written, numbered, own_image, raises, variant};

/// Which cards must not share a number with each other.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Family {
    /// Elements with stiffness; those of two kinds may share a number, which is said ([`crate::BulkData::remarks`]).
    Element,
    /// Masses.
    MassElement,
    /// Rigid elements and weighted means.
    RigidElement,
    /// Properties of shells.
    ShellProperty,
    /// Properties of bars and beams.
    BeamProperty,
    /// Materials.
    Material,
    /// Panels, whose numbers are those of their first boxes.
    Panel,
    /// All others: numbers are their kind's own.
    Own,
}

impl Family {
    /// All families.
    pub(crate) const ALL: [Self; 8] = [
        Self::Element,
        Self::MassElement,
        Self::RigidElement,
        Self::ShellProperty,
        Self::BeamProperty,
        Self::Material,
        Self::Panel,
        Self::Own,
    ];

    /// Its name in messages; none where a kind's numbers are its own.
    pub(crate) fn name(self) -> Option<&'static str> {
        match self {
            Self::Element => Some("element"),
            Self::MassElement => Some("mass element"),
            Self::RigidElement => Some("rigid element"),
            Self::ShellProperty => Some("shell property"),
            Self::BeamProperty => Some("beam property"),
            Self::Material => Some("material"),
            Self::Panel | Self::Own => None,
        }
    }

    /// Whether these are elements: with stiffness, with mass, or rigid.
    pub fn is_element(self) -> bool {
        matches!(self, Self::Element | Self::MassElement | Self::RigidElement)
    }
}

/// A kind of cards: what one field of [`crate::BulkData`] holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct CardKind {
    /// The field's name.
    pub field: &'static str,
    /// Whose numbers it must not share.
    pub family: Family,
    /// Names of the cards; some are only read (PBARL becomes a PBAR).
    pub names: &'static [&'static str],
}

impl CardKind {
    /// The name a card is written under.
    pub(crate) fn name(&self, card: &impl DeckCard) -> &'static str {
        self.names.get(card.variant()).copied().unwrap_or_default()
    }
}

/// What a deck keeps the cards of one kind in.
pub(crate) trait Cards {
    /// The kind's type.
    type Card: DeckCard;
    /// The cards in their order.
    fn each(&self) -> impl Iterator<Item = &Self::Card>;
    /// The cards in their order.
    fn taken(self) -> impl Iterator<Item = Self::Card>;
    /// Adds a card; fails with the place of one that has its number or name.
    fn put(&mut self, card: Self::Card) -> Result<(), Span>;
}

impl<C: DeckCard> Cards for BTreeMap<C::Key, C> {
    type Card = C;
    fn each(&self) -> impl Iterator<Item = &C> {
        self.values()
    }
    fn taken(self) -> impl Iterator<Item = C> {
        self.into_values()
    }
    fn put(&mut self, card: C) -> Result<(), Span> {
        let key = card.key();
        match self.get(&key) {
            Some(first) => Err(first.span().clone()),
            None => Ok(_ = self.insert(key, card)),
        }
    }
}

impl<C: DeckCard> Cards for Vec<C> {
    type Card = C;
    fn each(&self) -> impl Iterator<Item = &C> {
        self.iter()
    }
    fn taken(self) -> impl Iterator<Item = C> {
        self.into_iter()
    }
    fn put(&mut self, card: C) -> Result<(), Span> {
        self.push(card);
        Ok(())
    }
}

impl<C: DeckCard> Cards for Option<C> {
    type Card = C;
    fn each(&self) -> impl Iterator<Item = &C> {
        self.iter()
    }
    fn taken(self) -> impl Iterator<Item = C> {
        self.into_iter()
    }
    fn put(&mut self, card: C) -> Result<(), Span> {
        match self.replace(card) {
            Some(first) => Err(first.span().clone()),
            None => Ok(()),
        }
    }
}

/// By how much numbers are raised, so that several models can stand in one deck.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Step {
    /// Of everything except panels and their boxes.
    pub cards: u32,
    /// Of panels and boxes.
    pub boxes: u32,
}

impl Step {
    pub(super) fn cards(self, ids: &mut impl Ids) {
        ids.each(&mut |id| *id = id.saturating_add(self.cards));
    }

    /// Coordinate system 0 stays the basic one.
    pub(super) fn systems(self, ids: &mut impl Ids) {
        ids.each(&mut |id| *id = if *id == 0 { 0 } else { id.saturating_add(self.cards) });
    }

    pub(super) fn boxes(self, ids: &mut impl Ids) {
        ids.each(&mut |id| *id = id.saturating_add(self.boxes));
    }
}

/// What identification numbers stand in; components (digits) and values have none.
pub(super) trait Ids {
    /// Changes all of them.
    fn each(&mut self, change: &mut dyn FnMut(&mut u32));
}

impl Ids for u32 {
    fn each(&mut self, change: &mut dyn FnMut(&mut u32)) {
        change(self);
    }
}

/// A number below zero has a meaning of its own.
impl Ids for i32 {
    fn each(&mut self, change: &mut dyn FnMut(&mut u32)) {
        if let Ok(mut id) = u32::try_from(*self) {
            change(&mut id);
            *self = i32::try_from(id).unwrap_or(*self);
        }
    }
}

impl Ids for u8 {
    fn each(&mut self, _: &mut dyn FnMut(&mut u32)) {}
}

impl Ids for f64 {
    fn each(&mut self, _: &mut dyn FnMut(&mut u32)) {}
}

impl<A: Ids, B: Ids> Ids for (A, B) {
    fn each(&mut self, change: &mut dyn FnMut(&mut u32)) {
        self.0.each(change);
        self.1.each(change);
    }
}

impl<T: Ids, const N: usize> Ids for [T; N] {
    fn each(&mut self, change: &mut dyn FnMut(&mut u32)) {
        for part in self {
            part.each(change);
        }
    }
}

impl<T: Ids> Ids for Vec<T> {
    fn each(&mut self, change: &mut dyn FnMut(&mut u32)) {
        for part in self {
            part.each(change);
        }
    }
}

impl<T: Ids> Ids for Option<T> {
    fn each(&mut self, change: &mut dyn FnMut(&mut u32)) {
        if let Some(part) = self {
            part.each(change);
        }
    }
}

/// Turns coordinates of a system into the place in the basic one; the place blames the card if there is no system.
type Place<'a> = &'a dyn Fn(u32, Point3<f64>, &Span) -> Result<Point3<f64>, InputError>;

/// What a card needs to know of the deck that is mirrored about y = 0.
pub(crate) struct Mirror<'a> {
    /// Where coordinates of a system stand in the basic system.
    pub(crate) to_basic: Place<'a>,
    /// The image of each box.
    pub(crate) boxes: &'a BTreeMap<u32, u32>,
    /// AEFACT that divide the span.
    pub(crate) strips: BTreeSet<u32>,
}

impl Mirror<'_> {
    /// The image of a place given in a system, in the basic system.
    pub(super) fn place(
        &self,
        system: u32,
        xyz: Point3<f64>,
        span: &Span,
    ) -> Result<Point3<f64>, InputError> {
        (self.to_basic)(system, xyz, span).map(|point| flipped(point.coords).into())
    }
}

/// The image of a vector, or of a place from the origin, in basic axes.
pub(super) fn flipped(vector: Vector3<f64>) -> Vector3<f64> {
    Vector3::new(vector.x, minus(vector.y), vector.z)
}

/// Minus, without a negative zero.
pub(super) fn minus(value: f64) -> f64 {
    0.0 - value
}
