//! Checks of a static campaign, before anything is fitted: each answers in one sentence, with row or column and size.
//!
//! [`rows`]: single rows, their scatter, their airspeeds. [`units`]: factors that only a unit explains. [`causes`]: signs,
//! channels, places and tares, each by its own evidence against what panel models are usually off by. [`theory`]: what is
//! further from theory than panel models are, and what the campaign does not tell. `trust`: what the fit came to.

pub mod causes;
pub mod finding;
mod lines;
pub mod rows;
pub mod theory;
pub(crate) mod trust;
pub mod units;

use crate::campaign::Campaign;
use crate::statics::StaticData;
use coupling::{CouplingError, SteadyModel};
pub use finding::{Checked, Finding, Weight};
use lines::lines;

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
