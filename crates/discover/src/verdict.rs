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

/// The answer, from which verdict, sentence and success are told alike.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Answer<'j> {
    /// Effects with which the training data come nearer, and whether one of them has rivals.
    Named(&'j [&'j str], Rivals),
    /// Effects with which they do not: none of them is in the model.
    Withdrawn(&'j [&'j str]),
    /// Something is missing that has no name.
    Missing,
    /// Nothing is missing.
    Nothing,
}

/// Whether effects that are named have rivals.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Rivals {
    /// The data tell them from all others.
    None,
    /// The data do not.
    Some,
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

    /// The answer: a gap well above what is left where nothing is missing is not nothing, even if no effect has the evidence
    /// that it needs; and no effect is named with which the gap on training data does not shrink.
    pub fn answer(&self) -> Answer<'_> {
        let Gap { before, after, .. } = self.training;
        match &self.names[..] {
            [] if self.unexplained || self.is_far_above_floor() => Answer::Missing,
            [] => Answer::Nothing,
            names if after < before => {
                Answer::Named(names, if self.ambiguous { Rivals::Some } else { Rivals::None })
            }
            names => Answer::Withdrawn(names),
        }
    }

    /// The answer as results have it.
    pub fn kind(&self) -> VerdictKind {
        match self.answer() {
            Answer::Named(_, Rivals::None) => VerdictKind::Effects,
            Answer::Named(_, Rivals::Some) => VerdictKind::Ambiguous,
            Answer::Withdrawn(_) | Answer::Missing => VerdictKind::Unknown,
            Answer::Nothing => VerdictKind::None,
        }
    }

    /// Whether the gap of the training data is more than so many times what is left where nothing is missing.
    pub fn is_far_above_floor(&self) -> bool {
        self.training.after > self.closed * self.training.floor
    }

    /// Whether the training data come nearer with the effects in the model; true without any.
    pub fn is_supported(&self) -> bool {
        !matches!(self.answer(), Answer::Withdrawn(_))
    }

    /// Whether the held-out gap shrank, and to at most so many times what is left where nothing is missing.
    pub fn is_success(&self) -> bool {
        matches!(self.answer(), Answer::Named(..))
            && self.held_out.is_some_and(|gap| gap.is_closed(self.closed))
    }
}
