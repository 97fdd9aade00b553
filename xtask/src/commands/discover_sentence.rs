//! What `discover` found, in one sentence: nothing is claimed that the gaps do not show.

use crate::commands::discover::Discovered;
use crate::commands::discover_results::{CLOSED, is_far_above_floor, is_supported, success};

/// What the sentence is made of.
#[expect(clippy::struct_excessive_bools, reason = "four judgements that do not exclude each other")]
struct Said<'a> {
    names: Vec<&'a str>,
    /// Gap of the training data before and after, and where nothing is missing.
    training: [f64; 3],
    /// The same of held-out data; none without any.
    held_out: Option<[f64; 3]>,
    supported: bool,
    success: bool,
    /// The training gap after is far above its floor.
    far: bool,
    /// More is missing than the library explains.
    unexplained: bool,
    /// The best effect that was not named: name, evidence, what it needs.
    next: Option<(&'a str, f64, f64)>,
}

/// The sentence.
pub(crate) fn sentence(found: &Discovered<'_>) -> String {
    let outcome = &found.report.outcome;
    let [training, held_out] = found.report.gaps.map(|gaps| gaps.map(|gap| gap.all));
    let floor = found.limits.floor;
    let said = Said {
        names: outcome.found.iter().map(|found| found.active.effect.spec().name).collect(),
        training: [training[0], training[1], floor[0]],
        held_out: found.prepared.data.has_held_out().then_some([held_out[0], held_out[1], floor[1]]),
        supported: is_supported(found),
        success: success(found),
        far: is_far_above_floor(found),
        unexplained: outcome.unexplained,
        next: outcome.next_best.as_ref().map(|next| (next.name(), next.evidence, next.threshold)),
    };
    if said.names.is_empty() { said.nothing_named() } else { said.named() }
}

impl Said<'_> {
    fn named(&self) -> String {
        let names = self.names.join(" and ");
        let [before, after, floor] = self.training;
        if !self.supported {
            return format!(
                "With {names} in the model the gap on training data does not shrink ({before:.1} -> {after:.1}): these data do \
                 not support it, and wing.ron is as given."
            );
        }
        let judged = match self.held_out {
            None => format!(
                "With {names} the gap on training data goes from {before:.1} to {after:.1}; no data are held out to judge it by, \
                 so no success is claimed"
            ),
            Some([before, after, floor]) => {
                let end = if self.success {
                    format!(
                        "closed: at most {CLOSED:.0} times what is left where nothing is missing ({floor:.1})"
                    )
                } else if after < before {
                    format!(
                        "did not close to {CLOSED:.0} times what is left where nothing is missing ({floor:.1}): no success is \
                         claimed"
                    )
                } else {
                    "did not shrink: no success is claimed".to_owned()
                };
                format!("With {names} the held-out gap goes from {before:.1} to {after:.1}; it {end}")
            }
        };
        let more = if self.far {
            format!(
                ". More is missing: on training data {:.1} times what is left where nothing is missing stays",
                after / floor
            )
        } else {
            String::new()
        };
        format!("{judged}{more}.")
    }

    fn nothing_named(&self) -> String {
        let [gap, _, floor] = self.training;
        let next = self.next.map_or_else(String::new, |(name, evidence, needed)| {
            let why = if evidence > needed { "not told from others" } else { "too little" };
            format!(
                "; the nearest is {name} with a log Bayes factor of {evidence:.0}, {needed:.0} needed ({why})"
            )
        });
        if self.far {
            format!(
                "Something is missing: the gap on training data ({gap:.1}) is {:.1} times what is left where nothing is missing \
                 ({floor:.1}), but these data do not say which effect it is{next}.",
                gap / floor
            )
        } else if self.unexplained {
            format!("Something is missing that no effect of the library explains{next}.")
        } else {
            format!(
                "No effect above the floor: the gap on training data is {gap:.1}, where nothing is missing it is about {floor:.1}. \
                 Nothing was added; `detection_limits` has the sizes that would have been named."
            )
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Said;

    fn said() -> Said<'static> {
        Said {
            names: vec!["stall"],
            training: [4.0, 1.4, 1.2],
            held_out: Some([5.0, 2.0, 1.3]),
            supported: true,
            success: true,
            far: false,
            unexplained: false,
            next: None,
        }
    }

    #[test]
    fn what_makes_the_training_gap_larger_is_called_unsupported() {
        let said = Said { training: [3.8, 6.9, 1.2], supported: false, success: false, ..said() }.named();
        assert!(
            said.contains("does not shrink (3.8 -> 6.9)") && said.contains("do not support it"),
            "{said}"
        );
        assert!(!said.contains("closed"), "{said}");
    }

    #[test]
    fn success_is_claimed_of_held_out_data_alone() {
        assert!(said().named().contains("from 5.0 to 2.0; it closed"));
        for held_out in [None, Some([5.0, 4.0, 1.3]), Some([5.0, 6.0, 1.3])] {
            let said = Said { held_out, success: false, ..said() }.named();
            assert!(said.contains("no success is claimed") && !said.contains("closed:"), "{said}");
        }
    }

    #[test]
    fn a_gap_far_above_the_floor_does_not_read_as_if_all_were_fine() {
        let nothing = Said { names: Vec::new(), training: [13.2, 13.2, 2.4], far: true, ..said() };
        assert!(nothing.nothing_named().starts_with("Something is missing"));
        let more = Said { training: [56.0, 55.0, 7.7], success: false, far: true, ..said() }.named();
        assert!(more.contains("More is missing"), "{more}");
        let fine = Said { names: Vec::new(), ..said() }.nothing_named();
        assert!(fine.starts_with("No effect above the floor"), "{fine}");
    }
}
