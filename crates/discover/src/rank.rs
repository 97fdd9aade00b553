//! All candidates beside the effects of the current model: screened, the promising ones fitted, and what speaks for each.

use crate::candidate::{Refit, Screened};
use crate::current_model::{CurrentModel, Setting};
use crate::null_distribution::NullDistribution;
use crate::problem::Problem;
use maneuver::effects::Active;
use rayon::prelude::*;

/// Candidates that are fitted: so many, and all within a share of the best in screening.
const KEPT: usize = 8;
/// See above.
const KEPT_SHARE: f64 = 0.35;
/// What screening says chi square would fall by at least, far below any threshold; so many are fitted all the same.
const LEAST: f64 = 20.0;
/// See above.
const SHOWN: usize = 3;

/// A candidate's weight.
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

    /// Number of its parameters.
    pub(crate) fn parameters(&self) -> usize {
        self.refit.active.values.len()
    }

    /// Whether all its parameters may have either sign.
    pub(crate) fn has_two_sides(&self) -> bool {
        self.refit.active.parameters().iter().all(|one| one.lower < 0.0)
    }

    /// Whether it has one parameter, of one sign.
    pub(crate) fn has_one_side(&self) -> bool {
        matches!(&self.refit.active.parameters()[..], [one] if one.lower >= 0.0)
    }
}

/// All candidates beside the effects of the current model, by falling evidence.
pub fn rank(
    setting: &Setting<'_>,
    problem: &Problem<'_>,
    current: &CurrentModel,
    limits: &NullDistribution,
) -> Vec<Ranked> {
    rank_some(setting, (problem, current), limits, &|_| true, &[])
}

/// The same of some names; fits of `known` effects begin with their values, too.
pub(crate) fn rank_some(
    setting: &Setting<'_>,
    (problem, current): (&Problem<'_>, &CurrentModel),
    limits: &NullDistribution,
    wanted: &(dyn Fn(&str) -> bool + Sync),
    known: &[&Active],
) -> Vec<Ranked> {
    let taken: Vec<&str> = current.effects.iter().map(|active| active.effect.spec().name).collect();
    let mut screened: Vec<Screened> = setting
        .library
        .par_iter()
        .filter(|effect| !taken.contains(&effect.spec().name) && wanted(effect.spec().name))
        .map(|effect| {
            let screened = Screened::new(setting, problem, current, effect);
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
        *i < SHOWN || s.gain > LEAST && (*i < KEPT || s.gain > KEPT_SHARE * best)
    };
    let kept = screened.iter().enumerate().filter(kept).count();
    screened.truncate(kept);
    let refits: Vec<Refit> = screened.par_iter().map(|s| s.refit(setting, problem, current)).collect();
    let rows = problem.len() as f64;
    let least = refits.iter().map(|r| r.chi2).fold(current.chi2, f64::min);
    let phi = (least / rows).max(1.0);
    let mut candidates: Vec<Ranked> = refits
        .into_iter()
        .map(|refit| {
            let active = &refit.active;
            let threshold = limits.threshold(active.effect.spec().name, active.effect.form());
            Ranked { evidence: refit.evidence(current, phi), threshold, refit }
        })
        .collect();
    candidates.sort_by(|a, b| b.evidence.total_cmp(&a.evidence));
    candidates
}
