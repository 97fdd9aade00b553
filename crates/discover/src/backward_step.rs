//! Effects that were found, each judged again beside those found after it.

use crate::current_model::{CurrentModel, Setting, norm};
use crate::distinguish::CLOSE;
use crate::null_distribution::NullDistribution;
use crate::problem::Problem;
use crate::rank::{Ranked, rank_some};
use crate::search::{Found, name, no_repair, others, with_form};
use maneuver::effects::Active;

/// What was named with so many times the evidence of a later one is not replaced because of it.
const FIRM: f64 = 10.0;

/// Fits every effect again beside the others, takes a better one in its place, and drops what is not needed any more.
/// False if the last effect turned out to say what an earlier one says better: nothing more will be found then.
pub(crate) fn backward_step(
    setting: &Setting<'_>,
    (problem, bare): (&mut Problem<'_>, &(Problem<'_>, CurrentModel)),
    limits: &NullDistribution,
    found: &mut Vec<Found>,
    current: &mut CurrentModel,
) -> bool {
    let mut more = true;
    for index in (0..found.len()).rev().skip(1) {
        let without = current.beside(setting, problem, &others(found, &[index]));
        let names = found[index].considered.clone();
        let ranked = rank_some(
            setting,
            (problem, &without),
            limits,
            &|name| names.contains(&name),
            &[&found[index].active],
        );
        let last = found.len() - 1;
        let firm = found[index].named_at > FIRM * found[last].named_at;
        let least = if index == 0 { 0.0 } else { no_repair(found[0].named_at) };
        let counts = |w: &&Ranked| {
            w.evidence > w.threshold.max(least) && w.refit.is_itself() && !w.refit.is_within_prior()
        };
        if let Some(best) = ranked.iter().find(counts) {
            let own = ranked.iter().find(|w| w.name() == name(&found[index]));
            // the earlier name stays unless another is clearly better, and neither name nor values change unless all fits
            // better where nothing is allowed to the form of the effects beside it: what that hides decides nothing
            let beside = |w: &Ranked| {
                let mut effects = others(found, &[index]);
                effects.push(w.refit.active.clone());
                misfit_of(setting, bare, &effects)
            };
            let now = misfit_of(setting, bare, &others(found, &[]));
            let better = !firm && best.name() != name(&found[index]) && beside(best) < now;
            let chosen = own.filter(|own| !better || own.evidence > best.evidence - CLOSE);
            let chosen = chosen.or(better.then_some(best)).filter(|chosen| beside(chosen) <= now);
            let Some(chosen) = chosen else { continue };
            if chosen.name() != name(&found[index]) {
                found[index].confused_with.clear();
                found[index].rivals.clear();
            }
            found[index].active = chosen.refit.active.clone();
            found[index].sigma = with_form(&chosen.refit);
            found[index].evidence = chosen.evidence;
        } else {
            // one of the two is enough: the one that says more without the other
            let neither = current.beside(setting, problem, &others(found, &[index, last]));
            let names = [name(&found[index]), name(&found[last])];
            let both = [&found[index].active, &found[last].active];
            let alone = rank_some(setting, (problem, &neither), limits, &|name| names.contains(&name), &both);
            let evidence = |of: &Found| {
                alone.iter().find(|w| w.name() == name(of)).map_or(f64::NEG_INFINITY, |w| w.evidence)
            };
            if firm || evidence(&found[index]) >= evidence(&found[last]) {
                found.remove(last);
                more = false;
                break;
            }
            found.remove(index);
        }
    }
    let effects: Vec<Active> = found.iter().map(|f| f.active.clone()).collect();
    *current = CurrentModel::new(setting, problem, &effects, Some(&current.models));
    more
}

/// Chi square with effects, by the tolerances of the model without any.
fn misfit_of(
    setting: &Setting<'_>,
    (problem, current): &(Problem<'_>, CurrentModel),
    effects: &[Active],
) -> f64 {
    let models = setting.simulator.models(effects, Some(&current.models));
    let flown = setting.simulator.fly(&models, effects, &problem.places());
    norm(&current.shared, &problem.residual(&flown))
}
