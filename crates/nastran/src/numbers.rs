//! Numbers of a deck's cards: the largest, raised ones, distinct ones, and several models in one deck.

use crate::bulk_data::{BulkData, Change, Rest, Visitor};
use crate::cards::kind::{CardKind, Cards, DeckCard, Family, Step};
use crate::deck::damping::LossFactors;
use crate::source::InputError;
use std::collections::{BTreeMap, BTreeSet};

/// The numbers of the cards of some families.
struct Numbers<'a> {
    of: &'a [Family],
    found: BTreeSet<u32>,
}

impl Visitor for Numbers<'_> {
    fn cards(&mut self, kind: &CardKind, cards: &impl Cards) {
        if self.of.contains(&kind.family) {
            self.found.extend(cards.each().filter_map(DeckCard::number));
        }
    }
}

/// Elements with stiffness, by name, of each number.
#[derive(Default)]
struct Elements(BTreeMap<u32, Vec<String>>);

impl Visitor for Elements {
    fn cards(&mut self, kind: &CardKind, cards: &impl Cards) {
        for card in cards.each().filter(|_| kind.family == Family::Element) {
            self.0.entry(card.number().unwrap_or(0)).or_default().push(format!(
                "{} {}",
                kind.name(card),
                card.key()
            ));
        }
    }
}

/// Raises numbers.
struct Raise(Step);

impl Change for Raise {
    fn card<C: DeckCard>(&mut self, _: &CardKind, mut card: C) -> Result<Option<C>, InputError> {
        card.raise(self.0);
        Ok(Some(card))
    }
}

/// Leaves cards as they are.
struct Keep;

impl Change for Keep {
    fn card<C: DeckCard>(&mut self, _: &CardKind, card: C) -> Result<Option<C>, InputError> {
        Ok(Some(card))
    }
}

/// Gives cards of a family numbers that are not taken.
struct Distinct {
    family: Family,
    taken: BTreeSet<u32>,
    next: u32,
}

impl Change for Distinct {
    fn card<C: DeckCard>(&mut self, kind: &CardKind, mut card: C) -> Result<Option<C>, InputError> {
        let taken = card.number().filter(|id| kind.family == self.family && !self.taken.insert(*id));
        if taken.is_some() {
            card.renumber(self.next);
            self.taken.insert(self.next);
            self.next += 1;
        }
        Ok(Some(card))
    }
}

impl Step {
    /// Powers of ten above every number in a model, at least 10000 for cards and 1000000 for boxes, of which `last_box`
    /// is the largest number.
    pub fn above(bulk: &BulkData, last_box: u32) -> Self {
        let all: Vec<Family> = Family::ALL.into_iter().filter(|family| *family != Family::Panel).collect();
        let largest = bulk.numbers_of(&all).last().copied().unwrap_or(0);
        let power = |least: u32, above: u32| {
            std::iter::successors(Some(least), |power| power.checked_mul(10)).find(|power| *power > above)
        };
        // Nastran's numbers have at most 8 digits, so a power is found; if not, joining will name the collision.
        Self {
            cards: power(10_000, largest).unwrap_or(10_000),
            boxes: power(1_000_000, last_box).unwrap_or(1_000_000),
        }
    }
}

impl BulkData {
    /// Which elements of different kinds have one number: said to the user.
    pub(crate) fn shared_numbers(&self) -> Option<String> {
        /// How many numbers are named.
        const SHOWN: usize = 4;
        let mut elements = Elements::default();
        self.visit(&mut elements);
        let shared: Vec<String> = elements
            .0
            .into_values()
            .filter(|names| names.len() > 1)
            .map(|names| names.join(" and "))
            .collect();
        let more = match shared.len().saturating_sub(SHOWN) {
            0 => String::new(),
            more => format!(" and {more} more"),
        };
        let named = shared.iter().take(SHOWN).cloned().collect::<Vec<_>>().join(", ");
        (!shared.is_empty())
            .then(|| format!("elements of different kinds have one number, and each is kept: {named}{more}"))
    }

    fn numbers_of(&self, families: &[Family]) -> BTreeSet<u32> {
        let mut numbers = Numbers { of: families, found: BTreeSet::new() };
        self.visit(&mut numbers);
        numbers.found
    }

    /// The model with numbers raised and `prefix` before the labels of its control surfaces, without structural damping (GE).
    ///
    /// # Errors
    /// If numbers reach the end of their range and meet there.
    pub fn raised(self, by: Step, prefix: &str) -> Result<Self, InputError> {
        let mut new = Self::default();
        let rest = self.pour(&mut new, &mut Raise(by))?;
        Rest { loss_factors: LossFactors::default(), ..rest }.put(&mut new);
        for surface in new.surfaces.values_mut() {
            surface.label = format!("{prefix}{}", surface.label);
        }
        Ok(new)
    }

    /// Adds the cards of `other`; columns of matrices that both have are put behind each other, so its panels must have
    /// the higher numbers. Subcases, structural damping and cards that were not read are not taken over.
    ///
    /// # Errors
    /// If both use a number for the same kind of card, or measure mass in different units (PARAM WTMASS).
    pub fn join(&mut self, other: Self) -> Result<(), InputError> {
        other.refuse_added("joined to another model")?;
        let Rest {
            parameters,
            bars_twist,
            matrices,
            subcases: _,
            added: _,
            loss_factors: _,
            air_errors,
            unknown: _,
        } = other.pour(self, &mut Keep)?;
        self.air_errors.extend(air_errors);
        self.bars_twist |= bars_twist;
        for (name, value) in parameters {
            let first = self.parameters.entry(name.clone()).or_insert(value);
            if name == "WTMASS" && *first != value {
                let message = format!("two models have different PARAM WTMASS, {first} and {value}");
                return Err(InputError::general(message).with_help("give all of them in one system of units"));
            }
        }
        for (name, matrix) in matrices {
            match self.matrices.get_mut(&name) {
                Some(first) => {
                    first.rows += matrix.rows;
                    for (column, more) in first.columns.iter_mut().zip(matrix.columns) {
                        column.extend(more);
                    }
                }
                None => _ = self.matrices.insert(name, matrix),
            }
        }
        Ok(())
    }

    /// Gives masses and rigid elements numbers that no other element has, where they share one.
    ///
    /// # Panics
    /// Never: the new numbers are those that no card has.
    #[must_use]
    pub fn with_distinct_elements(mut self) -> Self {
        let mut taken = self.numbers_of(&[Family::Element]);
        let ties = [Family::MassElement, Family::RigidElement];
        let mut next = taken.iter().chain(&self.numbers_of(&ties)).max().map_or(1, |last| last + 1);
        for family in ties {
            let (mut new, mut change) = (Self::default(), Distinct { family, taken, next });
            let rest = self.pour(&mut new, &mut change).expect("numbers that are not taken do not meet");
            Rest { loss_factors: LossFactors::default(), ..rest }.put(&mut new);
            (self, taken, next) = (new, change.taken, change.next);
        }
        self
    }
}
