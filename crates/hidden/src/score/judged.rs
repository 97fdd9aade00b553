//! One case with its answer and its verdict.

use super::{Families, Verdict, VerdictKind};
use crate::answer::Answer;
use crate::effects::kind;
use crate::plan::Class;

/// See the module.
#[derive(Debug, Clone, Copy)]
pub(super) struct Judged<'a> {
    pub(super) answer: &'a Answer,
    pub(super) verdict: &'a Verdict,
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

    /// False names; of an ambiguous verdict, whose rivals are one claim, at most one.
    pub(super) fn false_names(&self) -> usize {
        let names = self.verdict.names();
        let wrong = names.iter().filter(|name| !self.is_right(name)).count();
        if self.verdict.kind == VerdictKind::Ambiguous {
            usize::from(wrong == names.len() && wrong > 0)
        } else {
            wrong
        }
    }

    /// Whether exactly what is hidden is named. A verdict that lists rivals names no structure.
    pub(super) fn is_exact(&self) -> bool {
        let names = self.verdict.names();
        let all = self.hidden().iter().all(|hidden| names.contains(hidden));
        self.verdict.kind != VerdictKind::Ambiguous && all && self.false_names() == 0
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
        match self.verdict.kind {
            VerdictKind::None => "none".to_owned(),
            VerdictKind::Unknown => "unknown".to_owned(),
            VerdictKind::DataDefect => "data_defect".to_owned(),
            VerdictKind::Effects | VerdictKind::Ambiguous => {
                let mut names = self.verdict.names();
                names.sort_unstable();
                let between = if self.verdict.kind == VerdictKind::Ambiguous { "|" } else { "+" };
                names.join(between)
            }
        }
    }
}
