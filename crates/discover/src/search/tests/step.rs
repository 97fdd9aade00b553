//! One step of a search.

use super::*;
use maneuver::effects::Parameter;

/// What is left over rows, after a is fitted.
fn phi(b: f64, rest: f64) -> f64 {
    ((squares(4.0)[1] + squares(b)[0] + rest * rest) / 32.0).max(1.0)
}

#[test]
fn an_effect_is_named_with_what_was_fitted() {
    let known = columns(4.0, 2.0, 3.0).ruled(|rules| rules.naming.value_form = 0.1);
    let nulls = known.nulls(20.0, 1.5);
    let mut so_far = so_far(&known, &nulls);
    assert!(so_far.step(&known.setting()));
    let [one] = &so_far.outcome.found[..] else { panic!("one effect") };
    let phi = phi(2.0, 3.0);
    assert_eq!(one.name(), "a");
    close(one.active.values[0], 3.75);
    close(one.sigma[0], f64::hypot(0.25, 0.375));
    close(one.evidence, evidence(4.0, phi));
    close(one.named_at, evidence(4.0, phi));
    // nothing is close to it
    assert!(one.confused_with.is_empty() && one.rivals.is_empty() && one.shares.is_empty());
    close(one.confidence, known.setting().rules().naming.right_alone[4].1);
    let first: Vec<&str> = so_far.outcome.first_ranking.iter().map(Ranked::name).collect();
    assert_eq!(first, ["a", "b"]);
    close(so_far.outcome.first_ranking[1].evidence, evidence(2.0, phi));
    assert!(so_far.outcome.next_best.is_none() && !so_far.undecided);
    assert_eq!(so_far.current.effects.len(), 1);
    close(so_far.current.effects[0].values[0], 3.75);
    close(so_far.current.chi2, 32.0 * phi);
    // nothing beside it was fitted again
    assert_eq!(so_far.outcome.trace.len(), 1);
}

/// b has 0.23 of the evidence of a.
#[test]
fn what_has_a_share_of_the_evidence_is_considered() {
    let considered = |share: f64, b: f64| {
        let known = columns(4.0, b, 3.0).ruled(|rules| rules.naming.considered = share);
        let nulls = known.nulls(5.0, 1.5);
        let mut so_far = so_far(&known, &nulls);
        assert!(so_far.step(&known.setting()));
        so_far.outcome.found[0].considered.clone()
    };
    let share = evidence(2.0, phi(2.0, 3.0)) / evidence(4.0, phi(2.0, 3.0));
    assert!(share > 0.2 && share < 0.25);
    assert_eq!(considered(0.99 * share, 2.0), ["a", "b"]);
    assert_eq!(considered(1.01 * share, 2.0), ["a"]);
    // not with just as much
    assert!(considered(1.0, 2.0).is_empty());
}

#[test]
fn effects_that_are_close_are_listed_beside_it_as_they_were_fitted() {
    // sure of what is beside others at sixty times what is needed: the second has twenty times that
    let known = columns(4.0, 3.9, 1.0).ruled(|rules| rules.naming.right_beside[1].0 = 60.0);
    let nulls = known.nulls(5.0, 1.5);
    let mut so_far = so_far(&known, &nulls);
    assert!(so_far.step(&known.setting()));
    let one = so_far.outcome.found[0].clone();
    assert_eq!((one.name(), &one.confused_with[..]), ("a", &["b"][..]));
    let [rival] = &one.rivals[..] else { panic!("one rival") };
    assert_eq!(rival.active.effect.spec().name, "b");
    close(rival.active.values[0], 3.9 * 15.0 / 16.0);
    close(one.confidence, known.setting().rules().naming.right_with_rivals[4].1);
    let at = evidence(4.0, phi(3.9, 1.0));
    close(one.named_at, at);
    // the other one is there, too; each is judged again beside the other, now that nothing is missing
    assert!(so_far.step(&known.setting()));
    assert_eq!(so_far.outcome.names(), ["a", "b"]);
    let [one, two] = &so_far.outcome.found[..] else { panic!("two effects") };
    close(two.named_at, evidence(3.9, 1.0));
    let naming = known.setting().rules().naming.clone();
    close(two.confidence, naming.share_beside(two.named_at / 5.0) * naming.right_alone[4].1);
    close(one.named_at, at);
    close(one.evidence, evidence(4.0, 1.0));
    assert_eq!(so_far.outcome.first_ranking.len(), 2);
    close(so_far.current.chi2, squares(4.0)[1] + squares(3.9)[1] + 1.0);
    // and no third
    assert!(!so_far.step(&known.setting()));
    assert!(so_far.outcome.next_best.is_none() && so_far.outcome.found.len() == 2);
}

/// Of two that fit nearly alike the one with fewer parameters is named, with the confidence that its own draws have beside a rival.
#[test]
fn what_is_simpler_is_named_and_the_other_is_its_rival() {
    let two = vec![Parameter::new("size", -100.0..=100.0, 1.0), Parameter::new("more", -100.0..=100.0, 1.0)];
    let known = ByHand::new(&[&steps(&[(0..15, 2.0)])])
        .column(made("both", &["one"], two), &steps(&[(0..15, 1.0)]))
        .column(made("one", &["both"], size()), &steps(&[(0..14, 1.0)]));
    let nulls = NullDistribution { model_form: 45.0, ..known.nulls(5.0, 1.5) };
    let mut so_far = so_far(&known, &nulls);
    assert!(so_far.step(&known.setting()));
    let one = &so_far.outcome.found[0];
    assert_eq!((one.name(), &one.confused_with[..]), ("one", &["both"][..]));
    close(one.active.values[0], 28.0 / 15.0);
    close(one.evidence, 28.0 * 28.0 / 30.0 - 0.5 * 15.0_f64.ln());
    // it wins no draw of one segment
    close(one.confidence, known.setting().rules().naming.right_with_rivals[0].1);
}

/// Whether a is named beside what nothing explains: 240 of 310 are its own, of which it leaves 15/16.
fn named(rule: impl FnOnce(&mut Rules), misfit: f64, misfit_limit: f64) -> bool {
    let known = columns(4.0, 2.0, 3.0).ruled(rule);
    let nulls = NullDistribution { misfit, ..known.nulls(20.0, misfit_limit) };
    let mut so_far = so_far(&known, &nulls);
    let named = so_far.step(&known.setting());
    assert_eq!(so_far.outcome.found.len(), usize::from(named));
    assert_eq!(so_far.outcome.trace.len(), 1);
    assert_eq!(so_far.outcome.next_best.as_ref().map(Ranked::name), (!named).then_some("a"));
    assert!(!so_far.undecided);
    named
}

#[test]
fn what_explains_little_of_what_is_missing_is_not_named() {
    let [before, after] = squares(4.0);
    let start = before + squares(2.0)[0] + 9.0;
    for misfit in [0.5, 2.0] {
        let explained = (before - after) / (start - 32.0 * misfit);
        assert!(named(|rules| rules.naming.explained = 0.999 * explained, misfit, 1.5));
        assert!(!named(|rules| rules.naming.explained = 1.001 * explained, misfit, 1.5));
    }
    // all of it: what is left is as much as where nothing is missing
    let known = columns(4.0, 2.0, 3.0);
    let nulls = known.nulls(20.0, 1.5);
    let left = rank(&known.setting(), &known.bare(), &nulls)[0].refit.chi2 / 32.0;
    assert!(named(|rules| rules.naming.explained = 1.0, left, 1.5));
    assert!(!named(|rules| rules.naming.explained = 1.0 + 1e-12, left, 1.5));
    // where no more is missing than may be, nothing need be explained
    let most = start / 32.0;
    assert!(named(|rules| rules.naming.explained = 9.0, 0.5, most));
    assert!(!named(|rules| rules.naming.explained = 9.0, 0.5, most * (1.0 - 1e-12)));
}

#[test]
fn what_wins_too_few_draws_is_not_named() {
    let undecided = |wins: f64, explained: f64| {
        let known = columns(4.0, 2.0, 3.0).ruled(|rules| {
            rules.naming.wins = wins;
            rules.naming.explained = explained;
        });
        let nulls = known.nulls(20.0, 1.5);
        let mut so_far = so_far(&known, &nulls);
        let named = so_far.step(&known.setting());
        assert_eq!(so_far.outcome.found.len(), usize::from(named));
        assert_eq!(so_far.outcome.next_best.is_some(), !named);
        (named, so_far.undecided)
    };
    // the points are one segment: each draw is the campaign itself, and its winner has them all
    assert_eq!(undecided(1.0, 0.1), (true, false));
    assert_eq!(undecided(1.1, 0.1), (false, true));
    assert_eq!(undecided(1.0, 9.0), (false, false));
    assert_eq!(undecided(0.5, 9.0), (false, false));
    assert_eq!(undecided(1.1, 9.0), (false, true));
}

#[test]
fn where_none_has_what_it_needs_the_first_is_the_next_best() {
    let known = columns(4.0, 2.0, 3.0);
    let nulls = known.nulls(1e3, 1.5);
    let mut so_far = so_far(&known, &nulls);
    assert!(!so_far.step(&known.setting()));
    assert!(so_far.outcome.found.is_empty() && so_far.outcome.trace.is_empty() && !so_far.undecided);
    assert_eq!(so_far.outcome.next_best.as_ref().map(Ranked::name), Some("a"));
    assert_eq!(so_far.outcome.first_ranking.len(), 2);
}

/// What an effect was named with before is told from it beside the next: a took part of what is b's.
#[test]
fn an_earlier_effect_is_fitted_again_beside_a_later_one() {
    let known = ByHand::new(&[&steps(&[(0..10, 3.0), (10..15, 9.0), (15..25, 6.0)])])
        .column(made("a", &[], size()), &steps(&[(0..15, 1.0)]))
        .column(made("b", &[], size()), &steps(&[(10..25, 1.0)]));
    let nulls = known.nulls(5.0, 1.5);
    let mut so_far = so_far(&known, &nulls);
    assert!(so_far.step(&known.setting()));
    assert_eq!(so_far.outcome.names(), ["b"]);
    let alone = (45.0 + 60.0) / 16.0;
    close(so_far.outcome.found[0].active.values[0], alone);
    assert!(so_far.step(&known.setting()));
    let values: Vec<f64> = so_far.outcome.found.iter().map(|found| found.active.values[0]).collect();
    // a beside b: its sum of 75 less five rows of b; b beside that: its sum of 105 less five rows of a
    let a = (75.0 - 5.0 * alone) / 16.0;
    close(values[1], a);
    close(values[0], (105.0 - 5.0 * a) / 16.0);
    close(so_far.current.effects[0].values[0], values[0]);
    close(so_far.current.effects[1].values[0], values[1]);
}
