//! Checks of a static campaign, before anything is fitted: each answers in one sentence, with row or column and size.
//!
//! [`rows`]: single rows, their scatter, their airspeeds. [`units`]: factors that only a unit explains. [`causes`]: signs,
//! channels, places and tares, each by its own evidence against what panel models are usually off by. [`theory`]: what is
//! further from theory than panel models are, and what the campaign does not tell. [`trust`]: what the fit came to.

pub mod causes;
mod lines;
pub mod rows;
pub mod theory;
pub(crate) mod trust;
pub mod units;

use crate::campaign::Campaign;
use crate::statics::StaticData;
use coupling::{CouplingError, SteadyModel};
use lines::lines;

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
    fn defect(sentence: String) -> Self {
        Self { sentence, weight: Weight::Defect }
    }

    fn suspicion(sentence: String) -> Self {
        Self { sentence, weight: Weight::Suspicion }
    }

    fn open(sentence: String) -> Self {
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

/// Checks a campaign and its rows, grouped.
///
/// # Errors
/// If the wing cannot be solved.
pub fn check<M: SteadyModel>(
    model: &M,
    campaign: &Campaign,
    data: StaticData,
) -> Result<Checked, CouplingError> {
    let mut checked = rows::check(campaign, data);
    let findings = &mut checked.findings;
    let units = units::of_campaign(model, campaign, &checked.data)?;
    let lines = lines(model, campaign.rho_kg_m3, &checked.data)?;
    if units.is_empty() {
        let causes = causes::find(model, campaign, &lines)?;
        if causes.is_empty() {
            findings.extend(theory::far_from_theory(&lines));
            findings.extend(theory::weight_or_camber(causes::weight(model, campaign)?, campaign, &lines));
        }
        findings.extend(causes);
    }
    findings.extend(units.into_iter().map(Finding::suspicion));
    findings.extend(theory::not_told(campaign));
    Ok(checked)
}
