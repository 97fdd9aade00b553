//! What a check found, and how much it weighs.

use crate::campaign::Campaign;
use crate::statics::StaticData;

/// How much a finding weighs.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Weight {
    /// Corrections of such data are not to be trusted: the calibration is no success.
    Defect,
    /// The numbers may be meant.
    Suspicion,
    /// What the campaign leaves open.
    Open,
}

/// What a check found.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Finding {
    /// What, where, how much, and what it probably is.
    pub sentence: String,
    /// How much it weighs.
    pub weight: Weight,
}

impl Finding {
    pub(super) fn defect(sentence: String) -> Self {
        Self { sentence, weight: Weight::Defect }
    }

    pub(crate) fn suspicion(sentence: String) -> Self {
        Self { sentence, weight: Weight::Suspicion }
    }

    pub(super) fn open(sentence: String) -> Self {
        Self { sentence, weight: Weight::Open }
    }
}

/// A campaign's data as they are to be fitted, and what was found in them.
#[derive(Debug, Clone)]
pub struct Checked {
    /// Without the rows set aside, and with the noise that rows show.
    pub campaign: Campaign,
    /// The same grouped.
    pub data: StaticData,
    /// What was found.
    pub findings: Vec<Finding>,
    /// Lines of the rows set aside.
    pub set_aside: Vec<usize>,
}
