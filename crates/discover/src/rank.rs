//! All candidates beside the effects of the current model: screened, the promising ones fitted, and what speaks for each.

use crate::candidate::{Refit, Screened};
use crate::current_model::CurrentModel;
use crate::null_distribution::NullDistribution;
use crate::rules::SharedRules;
use crate::setting::Setting;
use maneuver::effects::Active;
use rayon::prelude::*;
use std::sync::atomic::{AtomicUsize, Ordering};

/// A candidate's fit and what speaks for it.
#[derive(Debug, Clone)]
pub struct Ranked {
    /// The fit.
    pub refit: Refit,
    /// Logarithm of the Bayes factor against the current model.
    pub evidence: f64,
    /// Threshold it must pass.
    pub threshold: f64,
}

impl Ranked {
    /// Name of the effect.
    pub fn name(&self) -> &'static str {
        self.refit.active.effect.spec().name
    }

    /// Name and form, as the null distribution lists them.
    pub fn label(&self) -> String {
        format!("{} {}", self.name(), self.refit.active.effect.form())
    }

    /// Whether it has more than the evidence that is needed, its values are what its name says, and calibration could not
    /// have left them.
    pub(crate) fn counts(&self, needed: f64, rules: &SharedRules) -> bool {
        self.evidence > needed && self.refit.is_itself() && !self.refit.is_within_prior(rules)
    }

    /// Number of its parameters.
    pub(crate) fn parameters(&self) -> usize {
        self.refit.active.values.len()
    }
}

/// All candidates beside the effects of the current model, by falling evidence.
pub fn rank(setting: &Setting<'_>, current: &CurrentModel<'_>, nulls: &NullDistribution) -> Vec<Ranked> {
    rank_some(setting, current, nulls, &|_| true, &[])
}

/// The same of some names; fits of `known` effects begin with their values, too.
pub(crate) fn rank_some(
    setting: &Setting<'_>,
    current: &CurrentModel<'_>,
    nulls: &NullDistribution,
    wanted: &(dyn Fn(&str) -> bool + Sync),
    known: &[&Active],
) -> Vec<Ranked> {
    let rules = &setting.rules().rank;
    let taken: Vec<&str> = current.effects.iter().map(|active| active.effect.spec().name).collect();
    let mut screened: Vec<Screened> = setting
        .library
        .par_iter()
        .filter(|effect| !taken.contains(&effect.spec().name) && wanted(effect.spec().name))
        .map(|effect| {
            let screened = Screened::new(setting, current, effect);
            let same = |known: &&&Active| {
                known.effect.spec().name == effect.spec().name && known.effect.form() == effect.form()
            };
            match known.iter().find(same) {
                Some(known) => screened.also_from(known),
                None => screened,
            }
        })
        .collect();
    screened.sort_by(|a, b| b.gain.total_cmp(&a.gain));
    let best = screened.iter().map(|s| s.gain).filter(|gain| gain.is_finite()).fold(0.0, f64::max);
    let kept = |(i, s): &(usize, &Screened)| {
        *i < rules.shown
            || s.gain > rules.least_gain && (*i < rules.fitted || s.gain > rules.fitted_share * best)
    };
    let kept = screened.iter().enumerate().filter(kept).count();
    screened.truncate(kept);
    let done = AtomicUsize::new(0);
    let refit = |candidate: &Screened| {
        let refit = candidate.refit(setting, current);
        let done = done.fetch_add(1, Ordering::Relaxed) + 1;
        tracing::trace!(target: "progress", what = "candidates", done, total = screened.len());
        refit
    };
    let refits: Vec<Refit> = screened.par_iter().map(refit).collect();
    let rows = current.problem.len() as f64;
    let least = refits.iter().map(|r| r.chi2).fold(current.chi2, f64::min);
    let phi = (least / rows).max(1.0);
    let mut candidates: Vec<Ranked> = refits
        .into_iter()
        .map(|refit| {
            let active = &refit.active;
            let threshold = nulls.threshold(&active.effect);
            Ranked { evidence: refit.evidence(current, phi), threshold, refit }
        })
        .collect();
    candidates.sort_by(|a, b| b.evidence.total_cmp(&a.evidence));
    candidates
}

#[cfg(test)]
mod tests;
