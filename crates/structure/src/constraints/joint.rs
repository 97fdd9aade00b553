//! What a tie is when its nodes turn far.

use super::Dependent;
use nastran::Span;
use std::ops::Range;

/// How the motions of a tie follow at finite rotations.
#[derive(Debug, Clone, PartialEq)]
pub enum Joint {
    /// Nodes on rigid arms from one node.
    Rigid {
        /// The node that is followed.
        from: usize,
        /// The nodes that follow in all three displacements.
        to: Vec<usize>,
        /// Whether they follow in all three rotations as well; else these are free.
        turns: bool,
    },
    /// A node that follows the best fit of a rigid motion to a group.
    Mean {
        /// The node that follows in all three displacements.
        reference: usize,
        /// Whether it follows in all three rotations as well; else these are free.
        turns: bool,
        /// Nodes of the group, weight of their places, weight of their rotations.
        members: Vec<(usize, f64, f64)>,
    },
    /// Differences of one component of displacements in the same axes: exact at any rotation.
    Difference,
    /// Linear: exact for small rotations only.
    Linear,
}

/// A card that ties motions.
#[derive(Debug, Clone, PartialEq)]
pub struct Tie {
    /// The card, such as `RBE2 12`.
    pub owner: String,
    /// Where it stands.
    pub span: Option<Span>,
    /// What it does at finite rotations.
    pub joint: Joint,
    /// Its rows among [`crate::Model::dependents`].
    pub rows: Range<usize>,
}

impl Tie {
    /// Of the rows from `first` on.
    pub(crate) fn new(joint: Joint, dependents: &[Dependent], first: usize) -> Option<Self> {
        let own = dependents.get(first)?;
        let (owner, span) = (own.owner.clone(), Some(own.span.clone()));
        Some(Self { owner, span, joint, rows: first..dependents.len() })
    }
}

/// Whether a list of components (1 to 6) holds all displacements and nothing or all of the rotations: the latter; nothing
/// for any other list.
pub(crate) fn whole(components: &[u8]) -> Option<bool> {
    let has = |range: std::ops::RangeInclusive<u8>| range.filter(|c| components.contains(c)).count();
    match (has(1..=3), has(4..=6)) {
        (3, 0) => Some(false),
        (3, 3) => Some(true),
        _ => None,
    }
}
