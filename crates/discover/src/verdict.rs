//! What is said in the end: which answer, whether the data support it, whether the gap closed. Nothing is claimed that the gaps
//! do not show.

mod sentence;

use crate::found::Outcome;
use crate::rules::VerdictRules;
pub use response::verdict::{Gap, VerdictKind};

/// The best effect that was not named.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Nearest<'a> {
    /// Its name.
    pub name: &'a str,
    /// Its log Bayes factor.
    pub evidence: f64,
    /// What it needs.
    pub threshold: f64,
}

/// What a verdict rests on.
#[derive(Debug, Clone, PartialEq)]
pub struct Judgement<'a> {
    /// So many times its floor a gap may be at most to count as closed.
    pub closed: f64,
    /// Effects that were named.
    pub names: Vec<&'a str>,
    /// Whether one of them has rivals that the data do not tell from it.
    pub ambiguous: bool,
    /// Whether more is missing than the library explains.
    pub unexplained: bool,
    /// The best effect that was not named.
    pub nearest: Option<Nearest<'a>>,
    /// Gap of the training data.
    pub training: Gap,
    /// Gap of the held-out data; none without any.
    pub held_out: Option<Gap>,
}

impl<'a> Judgement<'a> {
    /// Of what a search ended with.
    pub fn new(rules: &VerdictRules, outcome: &'a Outcome, training: Gap, held_out: Option<Gap>) -> Self {
        Self {
            closed: rules.closed,
            names: outcome.names(),
            ambiguous: outcome.found.iter().any(|effect| !effect.confused_with.is_empty()),
            unexplained: outcome.unexplained,
            nearest: outcome.next_best.as_ref().map(|next| Nearest {
                name: next.name(),
                evidence: next.evidence,
                threshold: next.threshold,
            }),
            training,
            held_out,
        }
    }

    /// The answer: a gap well above what is left where nothing is missing is not `none`, even if no effect has the evidence
    /// that it needs.
    pub fn kind(&self) -> VerdictKind {
        match (self.names.is_empty(), self.ambiguous) {
            (true, _) if self.unexplained || self.is_far_above_floor() => VerdictKind::Unknown,
            (true, _) => VerdictKind::None,
            (false, true) => VerdictKind::Ambiguous,
            (false, false) => VerdictKind::Effects,
        }
    }

    /// Whether the gap of the training data is more than so many times what is left where nothing is missing.
    pub fn is_far_above_floor(&self) -> bool {
        self.training.after > self.closed * self.training.floor
    }

    /// Whether the training data come nearer with the effects in the model; true without any.
    pub fn is_supported(&self) -> bool {
        self.names.is_empty() || self.training.after < self.training.before
    }

    /// Whether the held-out gap shrank, and to at most so many times what is left where nothing is missing.
    pub fn is_success(&self) -> bool {
        !self.names.is_empty()
            && self.is_supported()
            && self.held_out.is_some_and(|gap| gap.is_closed(self.closed))
    }
}
