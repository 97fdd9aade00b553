//! Damping on cards of materials and elements, which nothing here computes with: it is counted, and said where it would count (flutter, gusts).

use crate::card::Card;
use crate::real;

/// Cards with structural damping (GE), and its field.
const STRUCTURAL: [(&str, usize); 9] = [
    ("MAT1", 7),
    ("MAT2", 12),
    ("MAT8", 16),
    ("MAT9", 30),
    ("CELAS2", 6),
    ("PELAS", 2),
    ("PELAS", 6),
    ("PCOMP", 6),
    ("PCOMPG", 6),
];

/// What counts such cards among those that are not read, such as `GE of MAT1`.
pub(crate) const PREFIX: &str = "GE of ";

/// The name of the damping that a card has; nothing if it has none.
pub(super) fn of(card: &Card) -> Option<String> {
    let is_set = |at: usize| real::parse(card.text(at)).is_some_and(|value| value != 0.0);
    let has_row =
        || (0..card.len()).any(|at| ["B", "GE"].contains(&card.text(at).to_ascii_uppercase().as_str()));
    let is_damped = STRUCTURAL.iter().any(|(name, at)| *name == card.name && is_set(*at))
        || (card.name == "PBUSH" && has_row());
    is_damped.then(|| format!("{PREFIX}{}", card.name))
}
