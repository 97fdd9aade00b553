//! The verdict in one sentence.

use super::{Answer, Gap, Judgement};

impl Judgement<'_> {
    /// The verdict in a sentence or two.
    pub fn sentence(&self) -> String {
        match self.answer() {
            Answer::Named(names, _) => self.named(names),
            Answer::Withdrawn(names) => self.withdrawn(names),
            Answer::Missing | Answer::Nothing => self.nothing_named(),
        }
    }

    fn withdrawn(&self, names: &[&str]) -> String {
        let Gap { before, after, .. } = self.training;
        format!(
            "Something is missing, and no effect of the library is it: with {} in the model the gap on training data does not \
             shrink ({before:.1} -> {after:.1}). Nothing is named, and wing.ron is as given.",
            names.join(" and ")
        )
    }

    fn named(&self, names: &[&str]) -> String {
        let names = names.join(" and ");
        let Gap { before, after, floor } = self.training;
        let judged = match self.held_out {
            None => format!(
                "With {names} the gap on training data goes from {before:.1} to {after:.1}; no data are held out to judge it by, \
                 so no success is claimed"
            ),
            Some(Gap { before, after, floor }) => {
                let times = self.closed;
                let end = if self.is_success() {
                    format!(
                        "closed: at most {times:.0} times the gap of a campaign in which nothing is missing ({floor:.1})"
                    )
                } else if after < before {
                    format!(
                        "did not close to {times:.0} times the gap of a campaign in which nothing is missing ({floor:.1}): no \
                         success is claimed"
                    )
                } else {
                    "did not shrink: no success is claimed".to_owned()
                };
                format!("With {names} the held-out gap goes from {before:.1} to {after:.1}; it {end}")
            }
        };
        let more = if self.is_far_above_floor() {
            format!(
                ". More is missing: the gap on training data stays {:.1} times that of a campaign in which nothing is missing",
                after / floor
            )
        } else {
            String::new()
        };
        format!("{judged}{more}.")
    }

    fn nothing_named(&self) -> String {
        let Gap { before: gap, floor, .. } = self.training;
        let nearest = self.nearest.map_or_else(String::new, |nearest| {
            let (evidence, needed) = (nearest.evidence, nearest.threshold);
            let why = if evidence > needed { "the data do not tell it from others" } else { "too little" };
            format!(
                "; the nearest is {} with a log Bayes factor of {evidence:.0}, {needed:.0} needed ({why})",
                nearest.name
            )
        });
        if self.is_far_above_floor() {
            format!(
                "Something is missing: the gap on training data ({gap:.1}) is {:.1} times that of a campaign in which nothing is \
                 missing ({floor:.1}), but these data do not say which effect it is{nearest}.",
                gap / floor
            )
        } else if self.unexplained {
            format!("Something is missing that no effect of the library explains{nearest}.")
        } else {
            format!(
                "No effect is missing beyond the detection limits: the gap on training data is {gap:.1}, that of a campaign in which \
                 nothing is missing about {floor:.1}. Nothing was added; `detection_limits` has the smallest sizes that would have \
                 been named."
            )
        }
    }
}
