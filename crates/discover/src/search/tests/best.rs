//! Which candidate goes first.

use super::{so_far, *};
use crate::by_hand::{found, ranked};
use maneuver::effects::Parameter;

fn both() -> Parameter {
    Parameter::new("size", -9.0..=9.0, 1.0)
}

fn up() -> Parameter {
    Parameter::new("size", 0.0..=9.0, 1.0)
}

/// A candidate with a log Bayes factor and its threshold.
fn candidate(name: &'static str, parameters: Vec<Parameter>, evidence: f64, threshold: f64) -> Ranked {
    let values = vec![1.0; parameters.len()];
    Ranked { threshold, ..ranked(&made(name, &[], parameters).active(&values), evidence, &[]) }
}

/// Its name, that of what it goes before, and what it needed, after some effects that were found with some evidence:
/// each a rival of the names beside it.
fn chosen(
    rules: &Rules,
    before: &[(f64, &'static [&'static str])],
    ranked: &[Ranked],
) -> Option<(&'static str, Option<&'static str>, f64)> {
    let known = ByHand::new(&[&[0.0]]);
    let nulls = NullDistribution { model_form: 45.0, ..known.nulls(1.0, 1.0) };
    let mut so_far = so_far(&known, &nulls);
    for (named_at, rivals) in before {
        so_far.outcome.found.push(found(&made("found", rivals, size()).active(&[1.0]), *named_at, &[]));
    }
    let best = so_far.best(ranked, rules)?;
    Some((best.candidate.name(), best.instead.map(Ranked::name), best.needed))
}

#[test]
fn the_first_with_what_it_needs_is_best() {
    let mut rules = Rules::default();
    rules.naming.repair_share_of_rival = 0.25;
    let three = [("x", 90.0, 95.0), ("y", 60.0, 25.0), ("z", 50.0, 10.0)]
        .map(|(name, evidence, threshold)| candidate(name, vec![both()], evidence, threshold));
    let of = |before: &[(f64, &'static [&'static str])]| chosen(&rules, before, &three);
    assert_eq!(of(&[]), Some(("y", None, 25.0)));
    assert_eq!(of(&[(400.0, &[])]), Some(("y", None, 25.0)));
    // a quarter of what its rival was named at, the larger of two; others have no say
    assert_eq!(of(&[(200.0, &["y"])]), Some(("y", None, 50.0)));
    assert_eq!(of(&[(160.0, &["y"]), (200.0, &["y", "x"])]), Some(("y", None, 50.0)));
    assert_eq!(of(&[(200.0, &["y"]), (160.0, &["y"])]), Some(("y", None, 50.0)));
    assert_eq!(of(&[(200.0, &["z"])]), Some(("y", None, 25.0)));
    assert_eq!(of(&[(120.0, &["y"])]), Some(("y", None, 30.0)));
    // as much as is needed is not enough
    assert_eq!(of(&[(240.0, &["y"])]), Some(("z", None, 10.0)));
    assert_eq!(of(&[(240.0, &["y"]), (200.0, &["z"])]), None);
    assert_eq!(chosen(&rules, &[], &three[..1]), None);
}

/// What has one sign only goes before what may have either, where neither model form nor a share of the evidence
/// tells them apart.
#[test]
fn what_has_one_side_goes_before_what_has_two_by_its_odds() {
    let mut rules = Rules::default();
    rules.rivals.close_share = 0.25;
    let of = |first: Vec<Parameter>, evidence: f64, others: Vec<(Vec<Parameter>, f64, f64)>| {
        let mut all = vec![candidate("first", first, evidence, 20.0)];
        for (name, (parameters, evidence, threshold)) in ["second", "third"].into_iter().zip(others) {
            all.push(candidate(name, parameters, evidence, threshold));
        }
        chosen(&rules, &[], &all).expect("the first has what it needs")
    };
    let (preferred, first) = (("second", Some("first"), 30.0), ("first", None, 20.0));
    let one = |evidence: f64| vec![(vec![up()], evidence, 30.0)];
    // a quarter of a hundred
    assert_eq!(of(vec![both()], 100.0, one(76.0)), preferred);
    assert_eq!(of(vec![both()], 100.0, one(75.0)), first);
    assert_eq!(of(vec![both()], 100.0, one(60.0)), first);
    // no more than the model's form makes of it
    assert_eq!(of(vec![both()], 400.0, one(356.0)), preferred);
    assert_eq!(of(vec![both()], 400.0, one(355.0)), first);
    assert_eq!(of(vec![both(), both()], 100.0, one(90.0)), preferred);
    // neither before its own kind, nor before what has a parameter of one sign
    assert_eq!(of(vec![up()], 100.0, one(98.0)), first);
    assert_eq!(of(vec![both(), up()], 100.0, one(90.0)), first);
    // nor what has two sides, or two parameters, or less than it needs
    assert_eq!(of(vec![both()], 100.0, vec![(vec![both()], 98.0, 30.0)]), first);
    assert_eq!(of(vec![both()], 100.0, vec![(vec![up(), up()], 98.0, 30.0)]), first);
    assert_eq!(of(vec![both()], 100.0, vec![(vec![up()], 98.0, 98.0)]), first);
    // the better one of two
    let two = vec![(vec![up()], 90.0, 30.0), (vec![up()], 80.0, 25.0)];
    assert_eq!(of(vec![both()], 100.0, two), preferred);
    let other = vec![(vec![up()], 90.0, 95.0), (vec![up()], 80.0, 25.0)];
    assert_eq!(of(vec![both()], 100.0, other), ("third", Some("first"), 25.0));
}

#[test]
fn fewer_parameters_go_before_more_that_say_hardly_more() {
    let mut rules = Rules::default();
    rules.rivals.close = 5.0;
    let of = |counts: &[(usize, f64, f64)]| {
        let mut all = Vec::new();
        for (name, (count, evidence, threshold)) in ["first", "second", "third"].into_iter().zip(counts) {
            all.push(candidate(name, vec![both(); *count], *evidence, *threshold));
        }
        chosen(&rules, &[], &all).expect("the first has what it needs")
    };
    let (simpler, first) = (("second", Some("first"), 30.0), ("first", None, 20.0));
    assert_eq!(of(&[(2, 100.0, 20.0), (1, 96.0, 30.0)]), simpler);
    assert_eq!(of(&[(3, 100.0, 20.0), (2, 96.0, 30.0), (1, 95.5, 40.0)]), simpler);
    assert_eq!(of(&[(2, 100.0, 20.0), (1, 95.0, 30.0)]), first);
    assert_eq!(of(&[(2, 100.0, 20.0), (2, 99.0, 30.0)]), first);
    assert_eq!(of(&[(1, 100.0, 20.0), (2, 99.0, 30.0)]), first);
    assert_eq!(of(&[(2, 100.0, 20.0), (1, 96.0, 97.0)]), first);
    assert_eq!(of(&[(2, 100.0, 20.0), (3, 98.0, 30.0), (1, 97.0, 40.0)]), ("third", Some("first"), 40.0));
    // odds before simplicity
    let all = [
        candidate("first", vec![both(), both()], 100.0, 20.0),
        candidate("simple", vec![both()], 98.0, 20.0),
        candidate("odd", vec![up()], 97.0, 25.0),
    ];
    assert_eq!(chosen(&rules, &[], &all), Some(("odd", Some("first"), 25.0)));
}
