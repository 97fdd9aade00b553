//! One case with its answer and its verdict.

use super::families::Families;
use crate::answer::Answer;
use crate::class::Class;
use crate::effects::kind;
use discover::result::{DiscoverResult, NamedEffect};
use discover::verdict::VerdictKind;

/// See the module.
#[derive(Debug, Clone, Copy)]
pub(super) struct Judged<'a> {
    pub(super) answer: &'a Answer,
    pub(super) verdict: &'a DiscoverResult,
    pub(super) families: &'a Families,
}

impl Judged<'_> {
    /// Names of what is hidden.
    pub(super) fn hidden(&self) -> Vec<&str> {
        self.answer.effects.iter().map(|effect| effect.name.as_str()).collect()
    }

    /// Whether the data are sound and all that is hidden is in the library that was used.
    pub(super) fn is_plain(&self) -> bool {
        let known = |name: &&str| kind(name).is_some_and(|kind| kind.in_library);
        self.answer.defect.is_none() && self.answer.leave_out.is_none() && self.hidden().iter().all(known)
    }

    /// Whether one effect of the library is hidden.
    pub(super) fn is_single(&self) -> bool {
        self.is_plain() && self.answer.effects.len() == 1
    }

    /// Whether two are.
    pub(super) fn is_pair(&self) -> bool {
        self.is_plain() && self.answer.effects.len() == 2
    }

    /// Whether nothing is.
    pub(super) fn is_null(&self) -> bool {
        self.answer.class == Class::Null
    }

    /// Whether no library can name it.
    pub(super) fn is_outside(&self) -> bool {
        self.answer.class == Class::OutOfLibrary
    }

    /// Whether a name is what is hidden.
    pub(super) fn is_right(&self, name: &str) -> bool {
        self.hidden().contains(&name)
    }

    /// Whether it is that or a twin.
    pub(super) fn is_kin(&self, name: &str) -> bool {
        self.hidden().iter().any(|hidden| self.families.are_kin(hidden, name))
    }

    /// The first name that is claimed.
    pub(super) fn first(&self) -> Option<&str> {
        self.verdict.names().first().copied()
    }

    /// Whether the first name is right.
    pub(super) fn first_is_right(&self) -> bool {
        self.first().is_some_and(|name| self.is_right(name))
    }

    /// Whether the first name is right or a twin.
    pub(super) fn first_is_kin(&self) -> bool {
        self.first().is_some_and(|name| self.is_kin(name))
    }

    /// Detectability of what is least visible of what is hidden.
    pub(super) fn d2(&self) -> f64 {
        self.answer.effects.iter().filter_map(|effect| effect.d2).fold(f64::INFINITY, f64::min)
    }

    /// False names; what a name may be confused with is no claim.
    pub(super) fn false_names(&self) -> usize {
        self.verdict.names().iter().filter(|name| !self.is_right(name)).count()
    }

    /// Whether exactly what is hidden is named.
    pub(super) fn is_exact(&self) -> bool {
        let names = self.verdict.names();
        self.hidden().iter().all(|hidden| names.contains(hidden)) && self.false_names() == 0
    }

    /// The same without rivals that the data cannot tell from it.
    pub(super) fn is_exact_and_sure(&self) -> bool {
        self.verdict.verdict != VerdictKind::Ambiguous && self.is_exact()
    }

    /// What was hidden, for the table of confusions.
    pub(super) fn hidden_as(&self) -> String {
        match (self.answer.class, &self.answer.defect) {
            (_, Some(_)) => "data_defect".to_owned(),
            (Class::Null, None) => "none".to_owned(),
            (Class::LeftOut, None) => format!("{} (left out)", self.hidden().join("+")),
            _ => {
                let mut names = self.hidden();
                names.sort_unstable();
                names.join("+")
            }
        }
    }

    /// What was answered, for the same table.
    pub(super) fn answered_as(&self) -> String {
        match self.verdict.verdict {
            VerdictKind::None => "none".to_owned(),
            VerdictKind::Unknown => "unknown".to_owned(),
            VerdictKind::DataDefect => "data_defect".to_owned(),
            VerdictKind::Effects | VerdictKind::Ambiguous => {
                let among = |effect: &NamedEffect| {
                    let mut rivals: Vec<&str> = effect.confused_with.iter().map(String::as_str).collect();
                    rivals.push(&effect.name);
                    rivals.sort_unstable();
                    rivals.join("|")
                };
                let mut names: Vec<String> = self.verdict.effects.iter().map(among).collect();
                names.sort_unstable();
                names.join("+")
            }
        }
    }
}
