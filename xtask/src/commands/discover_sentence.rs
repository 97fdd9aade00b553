//! What `discover` found, in one sentence: nothing is claimed that the gaps do not show.

use crate::commands::discover::Discovered;
use crate::commands::discover_results::{CLOSED, is_far_above_floor, is_supported, success};

/// The sentence.
pub(crate) fn sentence(found: &Discovered<'_>) -> String {
    if found.report.outcome.found.is_empty() { nothing_named(found) } else { named(found) }
}

fn named(found: &Discovered<'_>) -> String {
    let names: Vec<&str> = found.report.outcome.found.iter().map(|f| f.active.effect.spec().name).collect();
    let names = names.join(" and ");
    let [training, held_out] = found.report.gaps;
    if !is_supported(found) {
        return format!(
            "With {names} in the model the gap on training data does not shrink ({:.1} -> {:.1}): these data do not support it, \
             and wing.ron is as given.",
            training[0].all, training[1].all
        );
    }
    if !found.prepared.data.has_held_out() {
        return format!(
            "With {names} the gap on training data goes from {:.1} to {:.1}; no data are held out to judge it by, so no success \
             is claimed.",
            training[0].all, training[1].all
        );
    }
    let ([before, after], floor) = (held_out.map(|gap| gap.all), found.limits.floor[1]);
    let end = if success(found) {
        format!("closed: at most {CLOSED:.0} times what is left where nothing is missing ({floor:.1})")
    } else if after < before {
        format!(
            "did not close to {CLOSED:.0} times what is left where nothing is missing ({floor:.1}): no success is claimed"
        )
    } else {
        "did not shrink: no success is claimed".to_owned()
    };
    format!("With {names} the held-out gap goes from {before:.1} to {after:.1}; it {end}.")
}

fn nothing_named(found: &Discovered<'_>) -> String {
    let (gap, floor) = (found.report.gaps[0][0].all, found.limits.floor[0]);
    let next = found.report.outcome.next_best.as_ref().map_or_else(String::new, |next| {
        format!(
            "; the nearest is {} with {:.0} nats of evidence, {:.0} needed",
            next.name(),
            next.evidence,
            next.threshold
        )
    });
    if is_far_above_floor(found) {
        format!(
            "Something is missing: the gap on training data ({gap:.1}) is {:.1} times what is left where nothing is missing \
             ({floor:.1}), but these data do not say which effect it is{next}.",
            gap / floor
        )
    } else if found.report.outcome.unexplained {
        format!("Something is missing that no effect of the library explains{next}.")
    } else {
        format!(
            "No effect above the floor: the gap on training data ({gap:.1}) is about what is left where nothing is missing \
             ({floor:.1}). Nothing was added."
        )
    }
}
