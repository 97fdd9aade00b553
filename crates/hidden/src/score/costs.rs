//! Metrics of the gap before and after, and of what an answer costs.

use super::judged::Judged;
use super::metric::Metric;
use discover::result::StatedGap;
use std::collections::BTreeMap;

/// A gap this much above its floor is visible.
const VISIBLE: f64 = 1.2;

/// Adds the metrics.
pub(super) fn add(cases: &[Judged<'_>], metrics: &mut BTreeMap<String, Metric>) {
    let held_out = |case: &Judged<'_>| -> Option<StatedGap> {
        let gap = case.verdict.gap()?.holdout;
        (case.first_is_right() && gap.before > VISIBLE * gap.floor).then_some(gap)
    };
    let gaps: Vec<StatedGap> = cases.iter().filter_map(held_out).collect();
    let removed =
        gaps.iter().map(|gap| (gap.before - gap.after) / (gap.before - gap.floor).max(f64::MIN_POSITIVE));
    metrics.insert("gap_share_removed_median".to_owned(), Metric::median(removed.collect()));
    let ratios = gaps.iter().map(|gap| gap.after / gap.before);
    metrics.insert("gap_ratio_median".to_owned(), Metric::median(ratios.collect()));
    metrics.insert(
        "gap_within_twice_the_floor".to_owned(),
        Metric::share_of(&gaps, |gap| gap.after <= 2.0 * gap.floor),
    );
    let named = |case: &&Judged<'_>| case.is_plain() && !case.verdict.names().is_empty();
    let of_named: Vec<StatedGap> =
        cases.iter().filter(named).filter_map(|case| Some(case.verdict.gap()?.holdout)).collect();
    let (visible, others): (Vec<StatedGap>, Vec<StatedGap>) =
        of_named.into_iter().partition(|gap| gap.before > VISIBLE * gap.floor);
    metrics.insert("gap_shrinks".to_owned(), Metric::share_of(&visible, |gap| gap.after < gap.before));
    metrics.insert(
        "gap_of_invisible_stays".to_owned(),
        Metric::share_of(&others, |gap| gap.after <= VISIBLE * gap.floor),
    );
    metrics.insert(
        "gap_of_nulls_over_floor_median".to_owned(),
        Metric::median(
            cases
                .iter()
                .filter(|case| case.is_null())
                .filter_map(|case| case.verdict.gap().map(|gap| gap.holdout.before / gap.holdout.floor))
                .filter(|ratio| ratio.is_finite())
                .collect(),
        ),
    );
    let seconds: Vec<f64> = cases.iter().filter_map(|case| case.verdict.seconds).collect();
    metrics.insert("seconds_mean".to_owned(), Metric::mean(&seconds));
    metrics.insert(
        "seconds_most".to_owned(),
        Metric::number(seconds.iter().copied().reduce(f64::max), seconds.len()),
    );
    let runs: Vec<f64> =
        cases.iter().filter_map(|case| Some(case.verdict.search.as_ref()?.model_runs? as f64)).collect();
    metrics.insert("model_runs_mean".to_owned(), Metric::mean(&runs));
}
