//! The scorer on verdicts whose metrics are known beforehand.

use discover::result::{DiscoverResult, Estimate, NamedEffect, SearchResult, StatedGap, StatedGaps};
use discover::verdict::VerdictKind;
use hidden::answer::{TrueEffect, TrueParameter};
use hidden::score::{Bound, Metric, gates};
use hidden::{Answer, Class, Defect, Families, Metrics, score};

fn answer(class: Class, effects: &[(&str, f64)]) -> Answer {
    let effect = |(name, d2): &(&str, f64)| TrueEffect {
        name: (*name).to_owned(),
        parameters: vec![TrueParameter { name: "size".to_owned(), value: 2.0, size: true }],
        d2: Some(*d2),
    };
    Answer {
        list_seed: 0,
        index: 0,
        class,
        effects: effects.iter().map(effect).collect(),
        defect: None,
        leave_out: None,
        d2: None,
    }
}

fn verdict(kind: VerdictKind, names: &[(&str, f64)]) -> DiscoverResult {
    let named = |(name, confidence): &(&str, f64)| NamedEffect {
        name: (*name).to_owned(),
        confidence: Some(*confidence),
        parameters: [("size".to_owned(), Estimate { value: 2.2, sigma: Some(0.2) })].into(),
        ..NamedEffect::default()
    };
    let gap = StatedGap { before: 10.0, after: 3.0, floor: 2.0, ..StatedGap::default() };
    let search = SearchResult {
        gap: Some(StatedGaps { training: gap, holdout: gap }),
        model_runs: Some(400),
        ..SearchResult::default()
    };
    DiscoverResult {
        verdict: kind,
        effects: names.iter().map(named).collect(),
        search: Some(search),
        ..DiscoverResult::at_fault(Vec::new(), None, 2.0)
    }
}

fn families() -> Families {
    Families::frozen().expect("the shipped families")
}

#[test]
fn a_mixed_list_has_the_metrics_that_are_counted_by_hand() {
    use Class::{LeftOut, Null, OutOfLibrary, Pair, Single};
    use VerdictKind::{Ambiguous, Effects, None as Nothing, Unknown};
    let cases = [
        (answer(Null, &[]), verdict(Nothing, &[])),
        (answer(Null, &[]), verdict(Effects, &[("stall", 0.7)])),
        (answer(Single, &[("stall", 5000.0)]), verdict(Effects, &[("stall", 0.99)])),
        // a twin, and one name too many
        (answer(Single, &[("delay", 4000.0)]), verdict(Effects, &[("daq_filter", 0.9), ("friction", 0.6)])),
        (answer(Single, &[("camber", 500.0)]), verdict(Ambiguous, &[("camber", 0.5)])),
        (answer(Single, &[("gain", 20.0)]), verdict(Nothing, &[])),
        (
            answer(Pair, &[("stall", 900.0), ("gain", 800.0)]),
            verdict(Effects, &[("gain", 0.9), ("stall", 0.8)]),
        ),
        (answer(OutOfLibrary, &[("shedding_tone", 9e4)]), verdict(Unknown, &[])),
        (answer(LeftOut, &[("delay", 9e4)]), verdict(Effects, &[("daq_filter", 0.9)])),
    ];
    let mut cases = cases.to_vec();
    cases[4].1.effects[0].confused_with = vec!["alpha_offset".to_owned()];
    cases[8].0.leave_out = Some("delay".to_owned());
    let scored = score(&cases, &families());
    let value = |name: &str| scored.metrics[name].value.expect("cases");
    let close = |name: &str, expected: f64| {
        assert!((value(name) - expected).abs() < 1e-12, "{name}: {} for {expected}", value(name));
    };
    close("null_false_naming", 0.5);
    close("top1_clear", 0.5);
    close("top1_family_clear", 1.0);
    close("top1_visible", 1.0);
    close("family_in_set_clear", 1.0);
    close("family_in_set_near_floor", 0.0);
    close("silent_near_floor", 1.0);
    // named: a null, four right or twins (one a pair)
    close("precision", 3.0 / 5.0);
    close("precision_family", 4.0 / 5.0);
    close("set_coverage", 2.0 / 3.0);
    close("set_size", 5.0 / 3.0);
    // of three seen, two are exact, one of them beside a rival
    close("exact_structure", 2.0 / 3.0);
    close("exact_without_rivals", 1.0 / 3.0);
    close("extra_names", 0.25);
    close("pair_both", 1.0);
    close("out_of_library_flagged", 1.0);
    close("out_of_library_misnamed", 0.0);
    close("left_out_misnamed", 0.0);
    close("parameter_error_median", 0.1);
    close("parameter_90_coverage", 1.0);
    close("gap_share_removed_median", 7.0 / 8.0);
    close("gap_ratio_median", 0.3);
    close("seconds_most", 2.0);
    assert_eq!(scored.confusion["delay"]["daq_filter+friction"], 1);
    assert_eq!(scored.confusion["none"]["none"], 1);
    assert_eq!(scored.confusion["camber"]["alpha_offset|camber"], 1);
    assert_eq!(scored.metrics["null_false_naming"].n, 2);
}

#[test]
fn silence_is_no_false_name_and_no_hit() {
    let cases: Vec<_> = (0..70)
        .map(|_| (answer(Class::Null, &[]), verdict(VerdictKind::None, &[])))
        .chain([(answer(Class::Single, &[("stall", 5000.0)]), verdict(VerdictKind::None, &[]))])
        .collect();
    let scored = score(&cases, &families());
    let false_naming = scored.metrics["null_false_naming"];
    assert_eq!(false_naming.value, Some(0.0));
    // none of 70: 3.8415/73.8415
    assert!(false_naming.high.is_some_and(|high| (high - 0.0520).abs() < 5e-5));
    assert_eq!(scored.metrics["top1_clear"].value, Some(0.0));
    assert_eq!(scored.metrics["precision"].value, None);
    // every gate is of a metric that is there, and none is reached without cases
    let gates = gates(&scored);
    assert!(gates.iter().all(|gate| scored.metrics.contains_key(&gate.metric)));
    let reached = |name: &str| gates.iter().any(|gate| gate.metric == name && gate.reached);
    assert!(reached("null_false_naming") && !reached("top1_clear") && !reached("precision"));
}

#[test]
fn a_false_name_beside_what_is_hidden_is_not_exact() {
    use Class::{Pair, Paper, Single};
    let of = |class: Class, hidden: &[(&str, f64)], names: &[(&str, f64)]| {
        let scored = score(&[(answer(class, hidden), verdict(VerdictKind::Effects, names))], &families());
        move |metric: &str| scored.metrics[metric].value.expect("a case")
    };
    let stall = ("stall", 5000.0);
    let right = of(Single, &[stall], &[("stall", 0.9)]);
    let one_more = of(Single, &[stall], &[("stall", 0.9), ("friction", 0.6)]);
    assert_eq!((right("exact_structure"), one_more("exact_structure")), (1.0, 0.0));
    assert_eq!((right("exact_without_rivals"), one_more("exact_without_rivals")), (1.0, 0.0));
    assert_eq!((right("extra_names"), one_more("extra_names")), (0.0, 1.0), "and it is counted");
    let pair = [stall, ("gain", 800.0)];
    let right = of(Pair, &pair, &[("gain", 0.9), ("stall", 0.8)]);
    let one_more = of(Pair, &pair, &[("gain", 0.9), ("stall", 0.8), ("friction", 0.6)]);
    assert_eq!((right("pair_exact_visible"), one_more("pair_exact_visible")), (1.0, 0.0));
    assert_eq!((one_more("pair_both"), one_more("pair_extra_names")), (1.0, 1.0));
    let half = of(Pair, &pair, &[("gain", 0.9)]);
    assert_eq!((half("pair_exact_visible"), half("pair_one")), (0.0, 1.0), "one of two is not exact either");
    let paper = of(Paper, &[("joiner_inertia", 9e4)], &[("joiner_inertia", 0.9), ("gain", 0.6)]);
    assert_eq!(paper("paper_exact"), 0.0);
}

#[test]
fn a_gate_is_reached_up_to_its_bound_and_not_beyond() {
    let none = Metrics { cases: 1, metrics: [].into(), confusion: [].into() };
    let all = gates(&none);
    assert!(all.iter().any(|gate| gate.bound == Bound::AtMost));
    assert!(all.iter().any(|gate| gate.bound == Bound::AtLeast));
    for gate in all {
        let reached = |value: f64| {
            let metric = Metric { value: Some(value), low: None, high: None, n: 1 };
            let metrics = Metrics { metrics: [(gate.metric.clone(), metric)].into(), ..none.clone() };
            let of_metric = gates(&metrics).into_iter().find(|other| other.metric == gate.metric);
            of_metric.is_some_and(|gate| gate.reached)
        };
        let (low, high) = (reached(gate.limit - 1e-9), reached(gate.limit + 1e-9));
        assert!(reached(gate.limit), "{} at its bound", gate.metric);
        assert_eq!(
            (low, high),
            (gate.bound == Bound::AtMost, gate.bound == Bound::AtLeast),
            "{}",
            gate.metric
        );
    }
}

#[test]
fn the_ninety_per_cent_interval_is_1_645_standard_deviations_wide_to_either_side() {
    // The normal's 95 % point, 1.644854: Abramowitz and Stegun, Handbook of Mathematical Functions, Table 26.5 (Q = .05).
    let inside = |sigmas: f64| {
        let mut said = verdict(VerdictKind::Effects, &[("stall", 0.9)]);
        let estimate = Estimate { value: 2.0 + 0.1 * sigmas, sigma: Some(0.1) };
        said.effects[0].parameters = [("size".to_owned(), estimate)].into();
        let scored = score(&[(answer(Class::Single, &[("stall", 5000.0)]), said)], &families());
        scored.metrics["parameter_90_coverage"].value.expect("a case")
    };
    assert_eq!([inside(1.64), inside(-1.64)], [1.0; 2]);
    assert_eq!([inside(1.65), inside(-1.65)], [0.0; 2]);
}

#[test]
fn families_name_effects_that_exist_once() {
    let families = families();
    assert!(families.are_kin("delay", "daq_filter") && families.are_kin("stall", "stall"));
    assert!(!families.are_kin("delay", "camber"));
}

#[test]
fn answers_and_metrics_survive_their_files() {
    let answer = answer(Class::Pair, &[("stall", 900.0), ("gain", 800.0)]);
    let text = serde_json::to_string(&answer).expect("an answer");
    assert_eq!(serde_json::from_str::<Answer>(&text).expect("the same"), answer);
    let scored = score(&[(answer, verdict(VerdictKind::Unknown, &[]))], &families());
    let text = serde_json::to_string(&scored).expect("metrics");
    assert_eq!(serde_json::from_str::<hidden::Metrics>(&text).expect("the same"), scored);
}

/// A list's metrics by name.
fn scored(cases: &[(Answer, DiscoverResult)]) -> impl Fn(&str) -> Option<f64> + use<> {
    let scored = score(cases, &families());
    move |name| scored.metrics[name].value
}

fn is_close(value: Option<f64>, expected: f64) -> bool {
    value.is_some_and(|value| (value - expected).abs() < 1e-12)
}

#[test]
fn gaps_count_where_what_was_named_rightly_can_be_seen() {
    use Class::{Null, Single};
    let with_gap = |class: Class, hidden: &[(&str, f64)], named: &[(&str, f64)], gap: [f64; 3]| {
        let kind = if named.is_empty() { VerdictKind::None } else { VerdictKind::Effects };
        let mut said = verdict(kind, named);
        let [before, after, floor] = gap;
        let gap = StatedGap { before, after, floor, ..StatedGap::default() };
        said.search.as_mut().expect("a search").gap = Some(StatedGaps { training: gap, holdout: gap });
        (answer(class, hidden), said)
    };
    let (stall, gain) = (("stall", 5000.0), ("gain", 5000.0));
    let value = scored(&[
        with_gap(Single, &[stall], &[("stall", 0.9)], [10.0, 3.0, 2.0]),
        with_gap(Single, &[gain], &[("gain", 0.9)], [10.0, 5.0, 1.0]),
        // a fifth above the floor is not seen, a wrong name closes nothing
        with_gap(Single, &[gain], &[("gain", 0.9)], [1.2, 1.0, 1.0]),
        with_gap(Single, &[gain], &[("stall", 0.9)], [30.0, 31.0, 1.0]),
        with_gap(Single, &[gain], &[("gain", 0.9)], [1.1, 1.3, 1.0]),
        with_gap(Null, &[], &[], [3.0, 3.0, 2.0]),
        with_gap(Null, &[], &[], [2.0, 2.0, 1.0]),
        with_gap(Null, &[], &[], [1.0, 1.0, 0.0]),
    ]);
    assert!(is_close(value("gap_share_removed_median"), 0.5 * (7.0 / 8.0 + 5.0 / 9.0)));
    assert!(is_close(value("gap_ratio_median"), 0.5 * (0.3 + 0.5)));
    assert!(is_close(value("gap_within_twice_the_floor"), 0.5));
    assert!(is_close(value("gap_shrinks"), 2.0 / 3.0));
    assert!(is_close(value("gap_of_invisible_stays"), 0.5));
    assert!(is_close(value("gap_of_nulls_over_floor_median"), 0.5 * (3.0 / 2.0 + 2.0 / 1.0)));
}

#[test]
fn each_verdict_is_counted_where_it_belongs() {
    use Class::{LeftOut, Null, OutOfLibrary, Pair, Single, Weak};
    use VerdictKind::{DataDefect, Effects, None as Nothing, Unknown};
    let left_out = |named: DiscoverResult| {
        let mut hidden = answer(LeftOut, &[("delay", 9e4), ("gain", 9e4)]);
        hidden.leave_out = Some("delay".to_owned());
        (hidden, named)
    };
    let faulty = |named: DiscoverResult| {
        let mut hidden = answer(Class::Defect, &[("stall", 9e4)]);
        hidden.defect = Some(Defect::NoReplicates);
        (hidden, named)
    };
    let both = [("stall", 900.0), ("gain", 800.0)];
    let cases = vec![
        (answer(Null, &[]), verdict(Unknown, &[])),
        (answer(Null, &[]), verdict(DataDefect, &[])),
        (answer(Null, &[]), verdict(Nothing, &[])),
        (answer(Single, &[("stall", 5000.0)]), verdict(Effects, &[("stall", 0.9)])),
        (answer(Single, &[("stall", 5000.0)]), verdict(Effects, &[("stall", 0.9)])),
        (answer(Single, &[("stall", 5000.0)]), verdict(Effects, &[("gain", 0.9)])),
        (answer(Single, &[("stall", 5000.0)]), verdict(Nothing, &[])),
        (answer(Weak, &[("stall", 10.0)]), verdict(Effects, &[("stall", 0.9)])),
        (answer(Weak, &[("stall", 20.0)]), verdict(Nothing, &[])),
        (answer(Single, &[("stall", 12.0)]), verdict(Nothing, &[])),
        (answer(Pair, &both), verdict(Effects, &[("gain", 0.9), ("stall", 0.8)])),
        (answer(Pair, &both), verdict(Effects, &[("gain", 0.9), ("stall", 0.8)])),
        (answer(Pair, &both), verdict(Effects, &[("gain", 0.9)])),
        // a library that has it after all, alone and with a false name beside it
        (answer(OutOfLibrary, &[("stall", 9e4)]), verdict(Effects, &[("stall", 0.9)])),
        (answer(OutOfLibrary, &[("stall", 9e4)]), verdict(Effects, &[("stall", 0.9), ("friction", 0.6)])),
        (answer(OutOfLibrary, &[("shedding_tone", 9e4)]), verdict(Unknown, &[])),
        left_out(verdict(Effects, &[("daq_filter", 0.9)])),
        left_out(verdict(Effects, &[("daq_filter", 0.9), ("stall", 0.9)])),
        left_out(verdict(Unknown, &[])),
        faulty(verdict(DataDefect, &[])),
        faulty(verdict(DataDefect, &[])),
        faulty(verdict(Effects, &[("stall", 0.9)])),
    ];
    let value = scored(&cases);
    let third = 1.0 / 3.0;
    for (name, expected) in [
        ("null_unknown", third),
        ("null_data_defect", third),
        // the two that the library has after all are singles like others
        ("wrong_clear", 0.5 * third),
        ("silent_clear", 0.5 * third),
        ("top1_weak_10", 1.0),
        ("top1_weak_30", 0.0),
        ("pair_both_visible", 2.0 * third),
        ("out_of_library_flagged", 2.0 * third),
        ("out_of_library_misnamed", third),
        ("left_out_any_misnamed", third),
        ("left_out_unknown", third),
        ("defect_refused", 2.0 * third),
        ("defect_named_effect", third),
        // what is left out of a library, or of faulty data, is not in the mix: six singles are named, and three pairs
        ("precision", 8.0 / 9.0),
    ] {
        assert!(is_close(value(name), expected), "{name}: {:?} for {expected}", value(name));
    }
    let confusion = score(&cases, &families()).confusion;
    assert_eq!(confusion["delay+gain (left out)"]["daq_filter"], 1);
    assert_eq!(confusion["data_defect"]["data_defect"], 2);
}

#[test]
fn confidences_are_those_of_names_that_are_claimed_in_the_mix() {
    use Class::{LeftOut, Null, Pair, Single};
    use VerdictKind::{Effects, Unknown};
    let mut left_out = answer(LeftOut, &[("delay", 9e4)]);
    left_out.leave_out = Some("delay".to_owned());
    let cases = vec![
        (answer(Single, &[("stall", 5000.0)]), verdict(Effects, &[("stall", 0.9)])),
        (answer(Null, &[]), verdict(Effects, &[("stall", 0.6)])),
        (
            answer(Pair, &[("stall", 900.0), ("gain", 800.0)]),
            verdict(Effects, &[("gain", 0.8), ("camber", 0.5)]),
        ),
        (left_out, verdict(Effects, &[("daq_filter", 0.3)])),
        // listed, but not claimed
        (answer(Single, &[("stall", 5000.0)]), verdict(Unknown, &[("stall", 0.2)])),
    ];
    let scored = score(&cases, &families());
    let brier = scored.metrics["confidence_brier"];
    assert_eq!((brier.n, scored.metrics["confidence_ece"].n), (4, 4));
    assert!(is_close(brier.value, (0.01 + 0.36 + 0.04 + 0.25) / 4.0));
    assert!(is_close(scored.metrics["confidence_ece"].value, (0.1 + 0.6 + 0.2 + 0.5) / 4.0));
    assert!(is_close(scored.metrics["overconfidence"].value, (-0.1 + 0.6 - 0.2 + 0.5) / 4.0));
    let (stated, right) =
        (scored.metrics["confidence_stated_bin_6"], scored.metrics["confidence_right_bin_6"]);
    assert!(is_close(stated.value, 0.6) && right.value == Some(0.0) && right.n == 1);
}

#[test]
fn sizes_are_compared_where_they_are_sizes_and_data_are_sound() {
    let two_parameters = |defect: Option<Defect>| {
        let mut hidden = answer(Class::Single, &[("stall", 5000.0)]);
        let place = TrueParameter { name: "place".to_owned(), value: 1.0, size: false };
        let none = TrueParameter { name: "none".to_owned(), value: 0.0, size: true };
        hidden.effects[0].parameters.extend([place, none]);
        hidden.defect = defect;
        let mut said = verdict(VerdictKind::Effects, &[("stall", 0.9)]);
        for name in ["place", "none"] {
            said.effects[0].parameters.insert(name.to_owned(), Estimate { value: 5.0, sigma: None });
        }
        score(&[(hidden, said)], &families()).metrics["parameter_error_median"]
    };
    let sound = two_parameters(None);
    assert!(sound.n == 1 && is_close(sound.value, 0.1));
    assert_eq!(two_parameters(Some(Defect::NoReplicates)).n, 0);
}
