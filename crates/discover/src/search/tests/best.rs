//! Which candidate goes first.

use super::{so_far, *};
use crate::by_hand::{found, ranked};
use maneuver::effects::Parameter;

fn both() -> Parameter {
    Parameter::new("size", -9.0..=9.0, 1.0)
}

/// A candidate with a log Bayes factor and its threshold.
fn candidate(name: &'static str, parameters: Vec<Parameter>, evidence: f64, threshold: f64) -> Ranked {
    let values = vec![1.0; parameters.len()];
    Ranked { threshold, ..ranked(&made(name, &[], parameters).active(&values), evidence, &[]) }
}

/// Its name and what it needed, after some effects that were found with some evidence: each a rival of the names beside it.
fn chosen(
    rules: &Rules,
    before: &[(f64, &'static [&'static str])],
    ranked: &[Ranked],
) -> Option<(&'static str, f64)> {
    let known = ByHand::new(&[&[0.0]]);
    let nulls = NullDistribution { model_form: 45.0, ..known.nulls(1.0, 1.0) };
    let mut so_far = so_far(&known, &nulls);
    for (named_at, rivals) in before {
        so_far.outcome.found.push(found(&made("found", rivals, size()).active(&[1.0]), *named_at, &[]));
    }
    so_far.best(ranked, rules).map(|(best, needed)| (best.name(), needed))
}

#[test]
fn the_first_with_what_it_needs_is_best() {
    let mut rules = Rules::default();
    rules.naming.repair_share_of_rival = 0.25;
    let three = [("x", 90.0, 95.0), ("y", 60.0, 25.0), ("z", 50.0, 10.0)]
        .map(|(name, evidence, threshold)| candidate(name, vec![both()], evidence, threshold));
    let of = |before: &[(f64, &'static [&'static str])]| chosen(&rules, before, &three);
    assert_eq!(of(&[]), Some(("y", 25.0)));
    assert_eq!(of(&[(400.0, &[])]), Some(("y", 25.0)));
    // a quarter of what its rival was named at, the larger of two; others have no say
    assert_eq!(of(&[(200.0, &["y"])]), Some(("y", 50.0)));
    assert_eq!(of(&[(160.0, &["y"]), (200.0, &["y", "x"])]), Some(("y", 50.0)));
    assert_eq!(of(&[(200.0, &["y"]), (160.0, &["y"])]), Some(("y", 50.0)));
    assert_eq!(of(&[(200.0, &["z"])]), Some(("y", 25.0)));
    assert_eq!(of(&[(120.0, &["y"])]), Some(("y", 30.0)));
    // as much as is needed is not enough
    assert_eq!(of(&[(240.0, &["y"])]), Some(("z", 10.0)));
    assert_eq!(of(&[(240.0, &["y"]), (200.0, &["z"])]), None);
    assert_eq!(chosen(&rules, &[], &three[..1]), None);
}

/// Where a share of what model form accounts for (45) may be all that they differ by; what its own form says more is a matter of size,
/// and decided by less.
#[test]
fn fewer_parameters_go_before_more_that_say_hardly_more() {
    let mut rules = Rules::default();
    (rules.rivals.close, rules.rivals.form_share) = (5.0, 0.2);
    let of = |names: [&'static str; 3], counts: &[(usize, f64, f64)]| {
        let mut all = Vec::new();
        for (name, (count, evidence, threshold)) in names.into_iter().zip(counts) {
            all.push(candidate(name, vec![both(); *count], *evidence, *threshold));
        }
        chosen(&rules, &[], &all).expect("the first has what it needs")
    };
    let (simpler, first) = (("second", 30.0), ("first", 20.0));
    let three = ["first", "second", "third"];
    assert_eq!(of(three, &[(2, 100.0, 20.0), (1, 91.5, 30.0)]), simpler);
    assert_eq!(of(three, &[(3, 100.0, 20.0), (2, 96.0, 30.0), (1, 95.5, 40.0)]), simpler);
    assert_eq!(of(three, &[(2, 100.0, 20.0), (1, 90.5, 30.0)]), first);
    assert_eq!(of(three, &[(2, 100.0, 20.0), (2, 99.0, 30.0)]), first);
    assert_eq!(of(three, &[(1, 100.0, 20.0), (2, 99.0, 30.0)]), first);
    assert_eq!(of(three, &[(2, 100.0, 20.0), (1, 96.0, 97.0)]), first);
    assert_eq!(of(three, &[(2, 100.0, 20.0), (3, 98.0, 30.0), (1, 97.0, 40.0)]), ("third", 40.0));
    // however much there is of both
    assert_eq!(of(three, &[(2, 800.0, 20.0), (1, 791.5, 30.0)]), simpler);
    assert_eq!(of(three, &[(2, 800.0, 20.0), (1, 790.5, 30.0)]), first);
    // forms of one effect: its name is not in question
    let forms = ["first", "first", "third"];
    assert_eq!(of(forms, &[(2, 100.0, 20.0), (1, 95.5, 30.0)]), ("first", 30.0));
    assert_eq!(of(forms, &[(2, 100.0, 20.0), (1, 95.0, 30.0)]), first);
    // other names are told apart by anything where nulls show nothing of model form
    rules.rivals.form_share = 0.0;
    let two = [("first", 2, 100.0), ("second", 1, 99.9)]
        .map(|(name, count, evidence)| candidate(name, vec![both(); count], evidence, 20.0));
    assert_eq!(chosen(&rules, &[], &two), Some(first));
}
