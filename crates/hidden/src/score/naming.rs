//! Metrics of naming: what is named on nulls, what comes first, sets, pairs, what no library has, defects.

use super::judged::Judged;
use super::metric::Metric;
use crate::class::Class;
use discover::verdict::VerdictKind;
use std::collections::BTreeMap;

/// Detectabilities between near the floor, visible and clear.
const VISIBLE_D2: f64 = 300.0;
const CLEAR_D2: f64 = 3000.0;

fn chosen<'c, 'a>(cases: &'c [Judged<'a>], of: impl Fn(&Judged<'a>) -> bool) -> Vec<&'c Judged<'a>> {
    cases.iter().filter(|case| of(case)).collect()
}

/// Adds the metrics.
pub(super) fn add(cases: &[Judged<'_>], metrics: &mut BTreeMap<String, Metric>) {
    let nulls = chosen(cases, Judged::is_null);
    let mut put = |name: &str, metric: Metric| metrics.insert(name.to_owned(), metric);
    put("null_false_naming", Metric::share_of(&nulls, |case| case.first().is_some()));
    put("null_unknown", Metric::share_of(&nulls, |case| case.verdict.verdict == VerdictKind::Unknown));
    put("null_data_defect", Metric::share_of(&nulls, |case| case.verdict.verdict == VerdictKind::DataDefect));
    let claimed =
        chosen(cases, |case| case.answer.defect.is_none() && is_in_mix(case) && case.first().is_some());
    put("precision", Metric::share_of(&claimed, |case| case.first_is_right()));
    put("precision_family", Metric::share_of(&claimed, |case| case.first_is_kin()));
    singles(cases, &mut put);
    several(cases, &mut put);
    outside(cases, &mut put);
}

/// Nulls, singles and pairs: what a user with a library that has it meets.
fn is_in_mix(case: &Judged<'_>) -> bool {
    case.is_null() || case.is_single() || case.is_pair()
}

fn singles(cases: &[Judged<'_>], put: &mut impl FnMut(&str, Metric) -> Option<Metric>) {
    let all = chosen(cases, Judged::is_single);
    let bins = [
        ("clear", CLEAR_D2, f64::INFINITY),
        ("visible", VISIBLE_D2, CLEAR_D2),
        ("near_floor", 0.0, VISIBLE_D2),
    ];
    for (name, from, to) in bins {
        let bin: Vec<&&Judged<'_>> = all.iter().filter(|case| (from..to).contains(&case.d2())).collect();
        put(&format!("top1_{name}"), Metric::share_of(&bin, |case| case.first_is_right()));
        put(&format!("top1_family_{name}"), Metric::share_of(&bin, |case| case.first_is_kin()));
        put(
            &format!("wrong_{name}"),
            Metric::share_of(&bin, |case| case.first().is_some() && !case.first_is_right()),
        );
        put(&format!("silent_{name}"), Metric::share_of(&bin, |case| case.first().is_none()));
        // what track B counts as right
        let kin_in_set = |case: &&&Judged<'_>| case.verdict.set().iter().any(|name| case.is_kin(name));
        put(&format!("family_in_set_{name}"), Metric::share_of(&bin, kin_in_set));
    }
    for (name, from, to) in
        [("10", 0.0, 17.0), ("30", 17.0, 55.0), ("100", 55.0, 173.0), ("300", 173.0, 550.0)]
    {
        let weak = |case: &&&Judged<'_>| case.answer.class == Class::Weak && (from..to).contains(&case.d2());
        let bin: Vec<&&Judged<'_>> = all.iter().filter(weak).collect();
        put(&format!("top1_weak_{name}"), Metric::share_of(&bin, |case| case.first_is_right()));
    }
    let named: Vec<&&Judged<'_>> = all.iter().filter(|case| case.first().is_some()).collect();
    let in_set = |case: &&&Judged<'_>| case.verdict.set().iter().any(|name| case.is_right(name));
    put("set_coverage", Metric::share_of(&named, in_set));
    let sizes: Vec<f64> = named.iter().map(|case| case.verdict.set().len() as f64).collect();
    put("set_size", Metric::mean(&sizes));
    let seen: Vec<&&Judged<'_>> = all.iter().filter(|case| case.d2() >= VISIBLE_D2).collect();
    put("exact_structure", Metric::share_of(&seen, |case| case.is_exact()));
    put("exact_without_rivals", Metric::share_of(&seen, |case| case.is_exact_and_sure()));
    // a wrong first name is counted elsewhere
    let extra = |case: &&Judged<'_>| {
        case.false_names().saturating_sub(usize::from(case.first().is_some() && !case.first_is_right()))
            as f64
    };
    put("extra_names", Metric::mean(&all.iter().map(extra).collect::<Vec<f64>>()));
    let paper = |case: &Judged<'_>| case.answer.class.is_of_paper();
    let paper = chosen(cases, paper);
    put("paper_exact", Metric::share_of(&paper, |case| case.is_exact()));
}

fn several(cases: &[Judged<'_>], put: &mut impl FnMut(&str, Metric) -> Option<Metric>) {
    let pairs = chosen(cases, |case| case.answer.class == Class::Pair);
    let found =
        |case: &Judged<'_>| case.hidden().iter().filter(|name| case.verdict.names().contains(name)).count();
    put("pair_both", Metric::share_of(&pairs, |case| found(case) == 2));
    put("pair_one", Metric::share_of(&pairs, |case| found(case) >= 1));
    let visible: Vec<&&Judged<'_>> = pairs.iter().filter(|case| case.d2() >= VISIBLE_D2).collect();
    put("pair_both_visible", Metric::share_of(&visible, |case| found(case) == 2));
    put("pair_exact_visible", Metric::share_of(&visible, |case| case.is_exact()));
    let extra: Vec<f64> = pairs.iter().map(|case| case.false_names() as f64).collect();
    put("pair_extra_names", Metric::mean(&extra));
}

fn outside(cases: &[Judged<'_>], put: &mut impl FnMut(&str, Metric) -> Option<Metric>) {
    let outside = chosen(cases, Judged::is_outside);
    // a library that has the effect after all may name it
    let flagged = |case: &&Judged<'_>| {
        case.verdict.verdict == VerdictKind::Unknown || (case.first_is_right() && case.is_exact())
    };
    put("out_of_library_flagged", Metric::share_of(&outside, flagged));
    let misnamed = |case: &&Judged<'_>| case.verdict.names().iter().any(|name| !case.is_right(name));
    put("out_of_library_misnamed", Metric::share_of(&outside, misnamed));
    let left = chosen(cases, |case| case.answer.class == Class::LeftOut);
    let first_strange = |case: &&Judged<'_>| case.first().is_some() && !case.first_is_kin();
    put("left_out_misnamed", Metric::share_of(&left, first_strange));
    let any_strange = |case: &&Judged<'_>| case.verdict.names().iter().any(|name| !case.is_kin(name));
    put("left_out_any_misnamed", Metric::share_of(&left, any_strange));
    put("left_out_unknown", Metric::share_of(&left, |case| case.verdict.verdict == VerdictKind::Unknown));
    let faulty = chosen(cases, |case| case.answer.defect.is_some());
    put("defect_refused", Metric::share_of(&faulty, |case| case.verdict.verdict == VerdictKind::DataDefect));
    put("defect_named_effect", Metric::share_of(&faulty, |case| case.first().is_some()));
}
