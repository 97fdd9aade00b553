//! Effects that were found, each judged again beside those found after it.

use crate::current_model::CurrentModel;
use crate::found::{Found, others};
use crate::null_distribution::NullDistribution;
use crate::rank::{Ranked, rank_some};
use crate::setting::Setting;

/// Fits every effect again beside the others, takes a better one in its place, and drops what is not needed any more.
/// False if the last effect turned out to say what an earlier one says better: nothing more will be found then.
pub(crate) fn backward_step<'a>(
    setting: &Setting<'_>,
    nulls: &NullDistribution,
    bare: &CurrentModel<'a>,
    found: &mut Vec<Found>,
    current: &mut CurrentModel<'a>,
) -> bool {
    let rules = setting.rules();
    let naming = &rules.naming;
    let mut more = true;
    for index in (0..found.len()).rev().skip(1) {
        let without = current.beside(setting, &others(found, &[index]));
        let names = found[index].considered.clone();
        let own = [&found[index].active];
        let ranked = rank_some(setting, &without, nulls, &|name| names.contains(&name), &own);
        let last = found.len() - 1;
        let firm = found[index].named_at > naming.firm * found[last].named_at;
        let counts = |w: &&Ranked| w.counts(w.threshold, &rules.shared);
        if let Some(best) = ranked.iter().find(counts) {
            let own = ranked.iter().find(|w| w.name() == found[index].name());
            // the earlier name stays unless another is clearly better, and neither name nor values change unless all fits
            // better where nothing is allowed to the form of the effects beside it: what that hides decides nothing
            let beside = |w: &Ranked| {
                let mut effects = others(found, &[index]);
                effects.push(w.refit.active.clone());
                bare.misfit_of(setting, &effects)
            };
            let now = bare.misfit_of(setting, &others(found, &[]));
            let better = !firm && best.name() != found[index].name() && beside(best) < now;
            let chosen = own.filter(|own| !better || own.evidence > best.evidence - rules.rivals.close);
            let chosen = chosen.or(better.then_some(best)).filter(|chosen| beside(chosen) <= now);
            let Some(chosen) = chosen else { continue };
            if chosen.name() != found[index].name() {
                found[index].confused_with.clear();
                found[index].rivals.clear();
            }
            found[index].take(chosen, naming);
        } else {
            // one of the two is enough: the one that says more without the other
            let neither = current.beside(setting, &others(found, &[index, last]));
            let names = [found[index].name(), found[last].name()];
            let both = [&found[index].active, &found[last].active];
            let alone = rank_some(setting, &neither, nulls, &|name| names.contains(&name), &both);
            let of = |of: &Found| alone.iter().find(|w| w.name() == of.name());
            let evidence = |found: &Found| of(found).map_or(f64::NEG_INFINITY, |w| w.evidence);
            let stays = firm || evidence(&found[index]) >= evidence(&found[last]);
            let (left, kept) = if stays { (last, index) } else { (index, last) };
            // its values were those beside the other
            if let Some(alone) = of(&found[kept]) {
                found[kept].take(alone, naming);
            }
            found.remove(left);
            if stays {
                more = false;
                break;
            }
        }
    }
    *current = current.with(setting, &others(found, &[]));
    more
}

#[cfg(test)]
mod tests;
