//! What a search says: which family is missing, whether others are as likely, whether anything is.

use crate::effect::{Effect, Family};
use crate::search::Found;
use response::verdict::VerdictKind;

/// Residuals so many times what the rig's file says are not explained, whatever was named.
const MOST_LEFT: f64 = 4.0;

/// The answer, from which verdict and sentence are told alike.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Answer<'f> {
    /// Effects that the data tell from all others.
    Named(&'f [Effect]),
    /// The first effect has rivals.
    Ambiguous(&'f [Effect], &'f [Family]),
    /// Something is missing that has no name.
    Missing,
    /// Nothing is missing.
    Nothing,
}

impl Found {
    /// The answer.
    pub fn answer(&self) -> Answer<'_> {
        let left = self.fitted.chi2 / self.residuals.max(1) as f64;
        match (&self.named[..], &self.rivals[..]) {
            (_, _) if left > MOST_LEFT => Answer::Missing,
            ([], _) => Answer::Nothing,
            (named, []) => Answer::Named(named),
            (named, rivals) => Answer::Ambiguous(named, rivals),
        }
    }
}

impl Answer<'_> {
    /// The answer as results have it.
    pub fn kind(&self) -> VerdictKind {
        match self {
            Self::Named(_) => VerdictKind::Effects,
            Self::Ambiguous(..) => VerdictKind::Ambiguous,
            Self::Missing => VerdictKind::Unknown,
            Self::Nothing => VerdictKind::None,
        }
    }

    /// The answer in a sentence.
    pub fn sentence(&self) -> String {
        let families = |named: &[Effect]| {
            named.iter().map(|effect| effect.family().title()).collect::<Vec<_>>().join(" and ")
        };
        match self {
            Self::Named(named) => format!("Missing from the linear rig: {}.", families(named)),
            Self::Ambiguous(named, rivals) => {
                let others: Vec<&str> = rivals.iter().map(|family| family.title()).collect();
                format!(
                    "Missing from the linear rig: {}; these data do not tell it from {}.",
                    families(named),
                    others.join(" or ")
                )
            }
            Self::Missing => {
                "Something is missing from the linear rig, and no effect of the library explains it.".into()
            }
            Self::Nothing => "The linear rig moves as was measured: nothing is missing.".into(),
        }
    }
}
