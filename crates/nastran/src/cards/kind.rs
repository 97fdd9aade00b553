//! What a deck asks of every card, and the tables it keeps the cards of one kind in.
//!
//! A new card is one file with its type and [`DeckCard`] for it, a field in [`crate::BulkData`] and a line in its list
//! of kinds; nothing compiles until all of them are there.

use crate::card::Card;
use crate::card::fields::Fields;
use crate::motion::Motion;
use crate::source::{InputError, Span};
use nalgebra::Point3;
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

/// The members of [`DeckCard`] for a card with an `id` and a `span`.
macro_rules! numbered {
    () => {
        type Key = u32;
        fn key(&self) -> u32 {
            self.id
        }
        fn number(&self) -> Option<u32> {
            Some(self.id)
        }
        fn renumber(&mut self, id: u32) {
            self.id = id;
        }
        fn span(&self) -> &Span {
            &self.span
        }
    };
}
pub(super) use numbered;

/// Which cards must not share a number with each other.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Family {
    /// Elements with stiffness.
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
    pub(super) fn card(self, id: &mut u32) {
        *id = id.saturating_add(self.cards);
    }

    pub(super) fn cards<'a>(self, ids: impl IntoIterator<Item = &'a mut u32>) {
        ids.into_iter().for_each(|id| self.card(id));
    }

    pub(super) fn motions<'a>(self, motions: impl IntoIterator<Item = &'a mut Motion>) {
        self.cards(motions.into_iter().map(|(grid, _)| grid));
    }

    /// Coordinate system 0 stays the basic one.
    pub(super) fn systems<'a>(self, ids: impl IntoIterator<Item = &'a mut u32>) {
        self.cards(ids.into_iter().filter(|id| **id != 0));
    }

    /// As [`Step::systems`], where -1 has a meaning of its own.
    pub(super) fn signed_system(self, id: &mut i32) {
        if let Ok(mut system) = u32::try_from(*id) {
            self.systems([&mut system]);
            *id = i32::try_from(system).unwrap_or(*id);
        }
    }

    pub(super) fn boxes<'a>(self, ids: impl IntoIterator<Item = &'a mut u32>) {
        ids.into_iter().for_each(|id| *id = id.saturating_add(self.boxes));
    }
}

/// Turns coordinates of a system into the place in the basic one; the place blames the card if there is no system.
type Place<'a> = &'a dyn Fn(u32, [f64; 3], &Span) -> Result<Point3<f64>, InputError>;

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
    pub(super) fn place(&self, system: u32, xyz: [f64; 3], span: &Span) -> Result<[f64; 3], InputError> {
        (self.to_basic)(system, xyz, span).map(|point| flipped(point.into()))
    }
}

/// The image of a point or vector in basic axes.
pub(super) fn flipped([x, y, z]: [f64; 3]) -> [f64; 3] {
    [x, minus(y), z]
}

/// Minus, without a negative zero.
pub(super) fn minus(value: f64) -> f64 {
    0.0 - value
}
