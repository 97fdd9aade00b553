//! Effects that were found, each judged again beside those found after it.

use crate::bank::Thresholds;
use crate::distinguish::CLOSE;
use crate::level::{Level, Setting, norm};
use crate::problem::Problem;
use crate::search::{Found, name, no_repair, others, with_form};
use crate::weigh::{Weighed, weigh_some};
use maneuver::effects::Active;

/// What was named with so many times the evidence of a later one is not replaced because of it.
const FIRM: f64 = 10.0;

/// Fits every effect again beside the others, takes a better one in its place, and drops what is not needed any more.
/// False if the last effect turned out to say what an earlier one says better: nothing more will be found then.
pub(crate) fn revise(
    setting: &Setting<'_>,
    (problem, bare): (&mut Problem<'_>, &(Problem<'_>, Level)),
    limits: &Thresholds,
    found: &mut Vec<Found>,
    level: &mut Level,
) -> bool {
    let mut more = true;
    for index in (0..found.len()).rev().skip(1) {
        let without = level.beside(setting, problem, &others(found, &[index]));
        let names = found[index].considered.clone();
        let weighed = weigh_some(
            setting,
            (problem, &without),
            limits,
            &|name| names.contains(&name),
            &[&found[index].active],
        );
        let last = found.len() - 1;
        let firm = found[index].named_at > FIRM * found[last].named_at;
        let least = if index == 0 { 0.0 } else { no_repair(found[0].named_at) };
        let counts = |w: &&Weighed| w.evidence > w.threshold.max(least) && w.refit.is_more_than_a_nudge();
        if let Some(best) = weighed.iter().find(counts) {
            let own = weighed.iter().find(|w| w.name() == name(&found[index]));
            // the earlier name stays unless another is clearly better, and neither name nor values change unless all fits
            // better where nothing is allowed to the form of the effects beside it: what that hides decides nothing
            let beside = |w: &Weighed| {
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
            let neither = level.beside(setting, problem, &others(found, &[index, last]));
            let names = [name(&found[index]), name(&found[last])];
            let both = [&found[index].active, &found[last].active];
            let alone =
                weigh_some(setting, (problem, &neither), limits, &|name| names.contains(&name), &both);
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
    *level = Level::new(setting, problem, &effects, Some(&level.models));
    more
}

/// Chi square with effects, by the tolerances of the model without any.
fn misfit_of(setting: &Setting<'_>, (problem, level): &(Problem<'_>, Level), effects: &[Active]) -> f64 {
    let models = setting.simulator.models(effects, Some(&level.models));
    let flown = setting.simulator.fly(&models, effects, &problem.places());
    norm(&level.shared, &problem.residual(&flown))
}
