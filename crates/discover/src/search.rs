//! Effects one after the other, each ranked against all others, until none is left that the data ask for.

use crate::backward_step::backward_step;
use crate::candidate::Refit;
use crate::consistency::{scatter, shares};
use crate::current_model::CurrentModel;
use crate::distinguish::{Draws, distinguish};
use crate::found::{Found, Outcome, others};
use crate::null_distribution::NullDistribution;
use crate::problem::Problem;
use crate::rank::{Ranked, rank};
use crate::rules::Rules;
use crate::setting::Setting;
use crate::settle::settle;

/// Searches a training problem.
pub fn search<'a>(
    setting: &Setting<'_>,
    problem: Problem<'a>,
    nulls: &NullDistribution,
    seed: u64,
) -> (Outcome, CurrentModel<'a>) {
    let bare = CurrentModel::bare(setting, problem);
    let (current, outcome) = (bare.clone(), Outcome::default());
    let (start, rows) = (bare.chi2, bare.problem.len() as f64);
    let so_far = SoFar { current, bare, outcome, undecided: false, nulls, seed };
    let Searched { mut outcome, current, undecided } = so_far.whole(setting);
    let current = settle(setting, current, &mut outcome.found);
    outcome.misfit = [start / rows, current.chi2 / rows];
    outcome.unexplained = outcome.misfit[1] > nulls.misfit_limit || undecided && outcome.found.is_empty();
    (outcome, current)
}

/// A search from its beginning to its end, before values are settled.
struct Searched<'a> {
    outcome: Outcome,
    /// The model with what was found.
    current: CurrentModel<'a>,
    /// Whether something was left out that may be there.
    undecided: bool,
}

/// Judges every effect from parts of the data, and drops those whose parts disagree (all, if the first is one: what was
/// found beside a wrong effect is not to be believed). Whether any was dropped.
fn judge_parts(setting: &Setting<'_>, current: &CurrentModel<'_>, limit: f64, outcome: &mut Outcome) -> bool {
    for (which, found) in outcome.found.iter_mut().enumerate() {
        found.shares = shares(setting, &current.strict(which), which);
    }
    let disagree = |found: &Found| {
        scatter(setting.rules(), &found.active, &found.shares).is_some_and(|scatter| scatter > limit)
    };
    for found in outcome.found.iter().filter(|found| disagree(found)) {
        let each: Vec<String> = found.shares.iter().map(ToString::to_string).collect();
        let name = found.name();
        outcome.trace.push(format!("{name} has no size of its own ({}): it only resembles", each.join(", ")));
    }
    let before = outcome.found.len();
    let is_first = outcome.found.first().is_some_and(disagree);
    outcome.found.retain(|found| !is_first && !disagree(found));
    outcome.found.len() < before
}

/// A search on its way.
struct SoFar<'a, 'n> {
    /// The model without any effect.
    bare: CurrentModel<'a>,
    /// The model with those found.
    current: CurrentModel<'a>,
    nulls: &'n NullDistribution,
    seed: u64,
    outcome: Outcome,
    undecided: bool,
}

impl<'a> SoFar<'a, '_> {
    /// All steps, and the judgement of what they found.
    fn whole(mut self, setting: &Setting<'_>) -> Searched<'a> {
        let rules = setting.rules();
        let most = rules.naming.most_effects;
        // what a step takes back a later one may find again: steps end, whatever they do
        for _ in 0..2 * most {
            if self.outcome.found.len() == most || !self.step(setting) {
                break;
            }
        }
        let Self { bare, mut current, mut outcome, undecided, nulls, .. } = self;
        // what was found beside an effect is no rival of it
        let names = outcome.names();
        for effect in &mut outcome.found {
            effect.confused_with.retain(|rival| !names.contains(rival));
            effect.rivals.retain(|rival| !names.contains(&rival.active.effect.spec().name));
        }
        let (rows, start) = (current.problem.len() as f64, bare.chi2);
        let is_too_much = |current: &CurrentModel<'_>| current.chi2 > rows * nulls.misfit_limit;
        let explained = (start - current.chi2) / (start - rows * nulls.misfit).max(f64::MIN_POSITIVE);
        if is_too_much(&current) && explained < rules.naming.explained_by_all && !outcome.found.is_empty() {
            outcome.trace.push(format!("all of it explains {explained:.2} of the misfit: none is named"));
            outcome.found.clear();
            current = current.with(setting, &[]);
        }
        let limits = &rules.consistency;
        let limit = if is_too_much(&current) { limits.scatter_unexplained } else { limits.scatter };
        let dropped = judge_parts(setting, &current, limit, &mut outcome);
        if outcome.found.len() != current.effects.len() {
            current = current.with(setting, &others(&outcome.found, &[]));
        }
        Searched { outcome, current, undecided: undecided || dropped }
    }

    /// Names one more effect, if there is one to name; whether there may be more.
    fn step(&mut self, setting: &Setting<'_>) -> bool {
        let (rules, nulls) = (setting.rules(), self.nulls);
        let naming = &rules.naming;
        let ranked = rank(setting, &self.current, nulls);
        if self.outcome.found.is_empty() {
            self.outcome.first_ranking.clone_from(&ranked);
        }
        let Some((best, needed)) = self.best(&ranked, rules) else {
            self.outcome.next_best = ranked.into_iter().next();
            return false;
        };
        let (rows, chi2) = (self.current.problem.len() as f64, self.current.chi2);
        let explained = (chi2 - best.refit.chi2) / (chi2 - rows * nulls.misfit).max(f64::MIN_POSITIVE);
        let Draws { own: share, with_rivals, confused_with } =
            distinguish(&rules.rivals, &self.current, &ranked, best, self.seed);
        let explains = chi2 <= rows * nulls.misfit_limit || explained >= naming.explained;
        if with_rivals < naming.wins || !explains {
            self.undecided = with_rivals < naming.wins;
            self.outcome.trace.push(format!(
                "{} at a log Bayes factor of {:.0} wins {with_rivals:.2} of the draws and explains {explained:.2} of the misfit: not named",
                best.name(),
                best.evidence
            ));
            self.outcome.next_best = Some(best.clone());
            return false;
        }
        let considered = |w: &&Ranked| w.evidence > naming.considered * best.evidence;
        self.outcome.trace.push(format!(
            "{} named at a log Bayes factor of {:.0}, {needed:.0} needed",
            best.name(),
            best.evidence
        ));
        let right = naming.confidence(share, !confused_with.is_empty());
        let is_first = self.outcome.found.is_empty();
        self.outcome.found.push(Found {
            active: best.refit.active.clone(),
            sigma: best.refit.sigma_with_form(naming),
            evidence: best.evidence,
            named_at: best.evidence,
            confidence: right * if is_first { 1.0 } else { naming.share_beside(best.evidence / needed) },
            rivals: confused_with.iter().filter_map(|name| fitted(&ranked, name)).collect(),
            confused_with,
            considered: ranked.iter().filter(considered).map(Ranked::name).collect(),
            shares: Vec::new(),
        });
        let effects = others(&self.outcome.found, &[]);
        if effects.len() == 1 {
            self.current = self.current.with(setting, &effects);
            return true;
        }
        self.current = self.current.beside(setting, &effects);
        let more = backward_step(setting, nulls, &self.bare, &mut self.outcome.found, &mut self.current);
        let names = self.outcome.names().join(", ");
        self.outcome.trace.push(format!("all fitted again: {names}"));
        more
    }

    /// The best candidate that has the evidence it needs, and how much that is; a simpler one goes before it, where the form of the model
    /// may make the difference.
    fn best<'r>(&self, ranked: &'r [Ranked], rules: &Rules) -> Option<(&'r Ranked, f64)> {
        let rivals = |w: &Ranked| {
            let found = self.outcome.found.iter();
            let rivals = found.filter(|f| f.active.effect.spec().is_rival_of(w.refit.active.effect.spec()));
            let share = rules.naming.repair_share_of_rival;
            rivals.map(|rival| share * rival.named_at).fold(0.0, f64::max)
        };
        let needed = |w: &Ranked| w.threshold.max(rivals(w));
        let counts = |w: &&Ranked| w.counts(needed(w), &rules.shared);
        let first = ranked.iter().find(counts)?;
        let form = rules.rivals.form_share * self.nulls.model_form;
        let simpler = |w: &&Ranked| {
            let close = if w.name() == first.name() { rules.rivals.close } else { form };
            counts(w) && w.parameters() < first.parameters() && first.evidence - w.evidence < close
        };
        let best = ranked.iter().find(simpler).unwrap_or(first);
        Some((best, needed(best)))
    }
}

/// The best fit of a name.
fn fitted(ranked: &[Ranked], name: &str) -> Option<Refit> {
    ranked.iter().find(|w| w.name() == name).map(|w| w.refit.clone())
}

#[cfg(test)]
mod tests;
