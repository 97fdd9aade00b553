//! Effects of columns of ones on some of 32 points, each judged again beside those found after it.

use super::*;
use crate::by_hand::{ByHand, found, made, ranked, size, steps};
use crate::null_distribution::label;
use crate::rules::Rules;
use maneuver::effects::Active;
use std::ops::Range;

/// Points that measure a value, and columns.
fn known(
    rule: impl FnOnce(&mut Rules),
    measured: &[(Range<usize>, f64)],
    columns: &[(&'static str, Range<usize>, f64)],
) -> ByHand {
    let mut known = ByHand::new(&[&steps(measured)]).ruled(rule);
    for (name, rows, value) in columns {
        known = known.column(made(name, &[], size()), &steps(&[(rows.clone(), *value)]));
    }
    known
}

/// Effects as they were found: name, value, evidence; each considered with all columns, and confused with another.
fn as_found(known: &ByHand, effects: &[(&str, f64, f64)], considered: &[&'static str]) -> Vec<Found> {
    let one = |(name, value, named_at): &(&str, f64, f64)| {
        let active = known.active(name, &[*value]);
        let rivals = vec![ranked(&active, *named_at, &[]).refit];
        Found { confused_with: vec!["other"], rivals, ..found(&active, *named_at, considered) }
    };
    effects.iter().map(one).collect()
}

/// Whether there may be more, and what is left, with thresholds of five; the model is the one with it.
fn stepped(known: &ByHand, found: Vec<Found>) -> (bool, Vec<Found>) {
    stepped_by(known, &known.nulls(5.0, 1.5), found)
}

/// The same with thresholds of null campaigns.
fn stepped_by(known: &ByHand, nulls: &NullDistribution, mut found: Vec<Found>) -> (bool, Vec<Found>) {
    let (setting, bare) = (known.setting(), known.bare());
    let mut current = known.model(&others(&found, &[]));
    let more = backward_step(&setting, nulls, &bare, &mut found, &mut current);
    assert_eq!(current.effects.len(), found.len());
    for (active, found) in current.effects.iter().zip(&found) {
        assert_eq!((active.effect.spec().name, &active.values), (found.name(), &found.active.values));
    }
    (more, found)
}

fn names(found: &[Found]) -> Vec<&'static str> {
    found.iter().map(Found::name).collect()
}

/// Log Bayes factor and value of a column of k on n rows where all measure m, beside noise: with `I = n k²` they are
/// `(n k m)²/(2 (1 + I)) - ½ ln(1 + I)` and `n k m/(1 + I)`.
fn fit(n: f64, k: f64, m: f64) -> (f64, f64) {
    let (information, product) = (n * k * k, n * k * m);
    let whole = 1.0 + information;
    (0.5 * product * product / whole - 0.5 * information.ln_1p(), product / whole)
}

fn close(a: f64, b: f64) {
    assert!((a - b).abs() < 1e-8 * (1.0 + b.abs()), "{a} {b}");
}

/// The evidence, value and standard deviation of a fit.
fn is(found: &Found, name: &str, n: f64, k: f64, m: f64) {
    let (evidence, value) = fit(n, k, m);
    assert_eq!(found.name(), name);
    close(found.evidence, evidence);
    close(found.active.values[0], value);
    close(found.sigma[0], f64::sqrt(1.0 / (1.0 + n * k * k)));
}

/// The value that a column is fitted with beside an effect, to the bit.
fn fitted_beside(known: &ByHand, name: &str, beside: Active) -> f64 {
    let (setting, nulls) = (known.setting(), known.nulls(5.0, 1.5));
    rank_some(&setting, &known.model(&[beside]), &nulls, &|one| one == name, &[])[0].refit.active.values[0]
}

/// Less b all of a measure three.
#[test]
fn an_effect_is_fitted_again_beside_a_later_one_and_keeps_its_name() {
    let known = known(
        |_| (),
        &[(0..10, 3.0), (10..15, 4.0), (15..25, 1.0)],
        &[("a", 0..15, 1.0), ("b", 10..25, 1.0), ("c", 0..12, 1.0)],
    );
    assert_eq!(fitted_beside(&known, "a", known.active("b", &[1.0])).to_bits(), (45.0_f64 / 16.0).to_bits());
    for before in [4.0, 3.25, 45.0 / 16.0] {
        let found = as_found(&known, &[("a", before, 60.0), ("b", 1.0, 30.0)], &["a", "b", "c"]);
        let (more, left) = stepped(&known, found);
        assert!(more);
        let [a, b] = &left[..] else { panic!("two effects") };
        // to the bit what it was already or better
        is(a, "a", 15.0, 1.0, 3.0);
        close(a.named_at, 60.0);
        assert_eq!((a.confused_with.len(), a.rivals.len()), (1, 1));
        assert_eq!((b.name(), &b.active.values[..]), ("b", &[1.0][..]));
        close(b.evidence, 30.0);
    }
    // one effect alone is left as it is
    let (more, left) = stepped(&known, as_found(&known, &[("a", 4.0, 60.0)], &["a"]));
    assert!(more && left.len() == 1);
    close(left[0].active.values[0], 4.0);
}

/// Twenty rows measure two: c has them all, a fifteen.
fn other(close: f64) -> ByHand {
    known(
        |rules| {
            rules.rivals.close = close;
            rules.naming.firm = 10.0;
        },
        &[(0..20, 2.0), (24..28, 3.0)],
        &[("a", 0..15, 1.0), ("b", 24..28, 1.0), ("c", 0..20, 1.0)],
    )
}

#[test]
fn a_name_that_is_clearly_better_takes_the_place_of_one_that_is_not_firm() {
    let of = |close: f64, named_at: f64, considered: &[&'static str]| {
        let known = other(close);
        let (more, mut left) =
            stepped(&known, as_found(&known, &[("a", 1.0, named_at), ("b", 3.0, 10.0)], considered));
        assert!(more && left.len() == 2 && left[1].name() == "b");
        left.swap_remove(0)
    };
    let all = ["a", "c"];
    // ten more evidence
    assert!(fit(20.0, 1.0, 2.0).0 - fit(15.0, 1.0, 2.0).0 > 9.0);
    for named_at in [9.0, 50.0, 100.0] {
        let c = of(5.0, named_at, &all);
        is(&c, "c", 20.0, 1.0, 2.0);
        close(c.named_at, named_at);
        assert!(c.confused_with.is_empty() && c.rivals.is_empty());
    }
    let stays = |a: &Found| {
        is(a, "a", 15.0, 1.0, 2.0);
        assert_eq!((a.confused_with.len(), a.rivals.len()), (1, 1));
    };
    // not clearly; or named with more than ten times the evidence of the last
    stays(&of(11.0, 50.0, &all));
    stays(&of(5.0, 101.0, &all));
    // where the other name was none to consider
    stays(&of(5.0, 50.0, &["a"]));
    // where its own was none: it goes, but if it is firm
    is(&of(5.0, 50.0, &["c"]), "c", 20.0, 1.0, 2.0);
    let firm = of(5.0, 101.0, &["c"]);
    assert_eq!((firm.name(), &firm.active.values[..]), ("a", &[1.0][..]));
    close(firm.evidence, 101.0);
}

#[test]
fn evidence_that_is_less_by_just_what_is_close_is_clearly_less() {
    let known = other(5.0);
    let nulls = known.nulls(5.0, 1.5);
    let (a, b) = (known.active("a", &[1.0]), known.active("b", &[3.0]));
    let ranked = rank_some(&known.setting(), &known.model(&[b]), &nulls, &|_| true, &[&a]);
    assert_eq!(ranked.iter().map(Ranked::name).collect::<Vec<_>>(), ["c", "a"]);
    let apart = ranked[0].evidence - ranked[1].evidence;
    close(apart, fit(20.0, 1.0, 2.0).0 - fit(15.0, 1.0, 2.0).0);
    for (close, name) in [(apart, "c"), (1.001 * apart, "a")] {
        let known = other(close);
        let found = as_found(&known, &[("a", 1.0, 50.0), ("b", 3.0, 10.0)], &["a", "c"]);
        assert_eq!(names(&stepped(&known, found).1), [name, "b"]);
    }
}

/// c has more evidence, as it needs no large size, and misses two points: those are worth more than what a is off by.
#[test]
fn a_name_that_leaves_more_takes_no_place() {
    let known = known(
        |_| (),
        &[(0..20, 3.0), (24..28, 3.0)],
        &[("a", 0..20, 0.4), ("b", 24..28, 1.0), ("c", 0..18, 1.0)],
    );
    let ((c, size_c), (a, size_a)) = (fit(18.0, 1.0, 3.0), fit(20.0, 0.4, 3.0));
    let left = |size: f64| 20.0 * (3.0 - 0.4 * size) * (3.0 - 0.4 * size);
    let left_by_c = 18.0 * (3.0 - size_c) * (3.0 - size_c) + 18.0;
    assert!(c > a + 5.0 && left(size_a) < left(5.2) && left(5.2) < left_by_c);
    let found = as_found(&known, &[("a", 5.2, 50.0), ("b", 3.0, 10.0)], &["a", "c"]);
    let (more, found) = stepped(&known, found);
    assert!(more);
    is(&found[0], "a", 20.0, 0.4, 3.0);
    // where a is off by more it goes
    let found = as_found(&known, &[("a", 5.0, 50.0), ("b", 3.0, 10.0)], &["a", "c"]);
    assert!(left(5.0) > left_by_c);
    is(&stepped(&known, found).1[0], "c", 18.0, 1.0, 3.0);
}

/// The loads of c at its best, 15/8 on each of fifteen rows, are those of a at 15/4: with its prior it would have less.
#[test]
fn values_that_leave_more_and_names_that_leave_as_much_are_not_taken() {
    let known = known(
        |rules| rules.rivals.close = 1.0,
        &[(0..15, 2.0), (24..28, 3.0)],
        &[("a", 0..15, 0.5), ("b", 24..28, 1.0), ("c", 0..15, 1.0)],
    );
    assert!(fit(15.0, 1.0, 2.0).0 > fit(15.0, 0.5, 2.0).0 + 1.0 && fit(15.0, 0.5, 2.0).1 < 3.7);
    assert_eq!(fitted_beside(&known, "c", known.active("b", &[3.0])).to_bits(), 1.875_f64.to_bits());
    let found = as_found(&known, &[("a", 3.75, 50.0), ("b", 3.0, 10.0)], &["a", "c"]);
    let (more, found) = stepped(&known, found);
    assert!(more);
    assert_eq!((found[0].name(), &found[0].active.values[..]), ("a", &[3.75][..]));
    close(found[0].evidence, 50.0);
    assert_eq!(found[0].confused_with.len(), 1);
}

/// Of two that say the same the one goes that says less alone: fifteen rows say more than fourteen. The other has the values that it has
/// without it.
#[test]
fn one_of_two_that_say_the_same_is_enough() {
    let of = |a: usize, b: usize, named_at: f64| {
        let columns = [("a", 0..a, 1.0), ("b", 0..b, 1.0)];
        let known = known(|rules| rules.naming.firm = 10.0, &[(0..15, 2.0)], &columns);
        let found = as_found(&known, &[("a", 0.1, named_at), ("b", 1.8, 10.0)], &["a", "b"]);
        let (more, left) = stepped(&known, found);
        is(&left[0], left[0].name(), if left[0].name() == "a" { a } else { b } as f64, 1.0, 2.0);
        (more, names(&left))
    };
    assert_eq!(of(14, 15, 50.0), (true, vec!["b"]));
    assert_eq!(of(14, 15, 100.0), (true, vec!["b"]));
    assert_eq!(of(15, 14, 50.0), (false, vec!["a"]));
    // the earlier one, if they say as much, or if it is firm
    assert_eq!(of(15, 15, 50.0), (false, vec!["a"]));
    assert_eq!(of(14, 15, 101.0), (false, vec!["a"]));
}

/// Each has ten rows of its own.
#[test]
fn every_effect_needs_its_threshold_beside_the_others() {
    let of = |threshold: f64, third: f64| {
        let known = known(
            |_| (),
            &[(0..10, 2.0), (10..20, 2.5), (20..30, third)],
            &[("a", 0..10, 1.0), ("b", 10..20, 1.0), ("c", 20..30, 1.0)],
        );
        let effects = [("a", 1.5, 1000.0), ("b", 1.5, 400.0), ("c", third, 200.0)];
        let mut found = as_found(&known, &effects, &["a", "b", "c"]);
        found[0].considered = vec!["a"];
        let mut nulls = known.nulls(threshold, 1.5);
        nulls.evidence.insert(label(known.effect("a")), 5.0);
        stepped_by(&known, &nulls, found)
    };
    let (a, b) = (fit(10.0, 1.0, 2.0).0, fit(10.0, 1.0, 2.5).0);
    assert!(5.0 < a && a < 20.0 && 20.0 < b && b < 30.0);
    let (more, all) = of(20.0, 4.0);
    assert!(more && names(&all) == ["a", "b", "c"]);
    is(&all[0], "a", 10.0, 1.0, 2.0);
    is(&all[1], "b", 10.0, 1.0, 2.5);
    // b has less: it goes, as c has more, and a is fitted again beside c
    let (more, two) = of(30.0, 4.0);
    assert!(more && names(&two) == ["a", "c"]);
    close(two[0].active.values[0], fit(10.0, 1.0, 2.0).1);
    // c has less than b: it goes, b is fitted without it, and nothing more is judged
    let (more, two) = of(30.0, 2.2);
    assert!(!more && names(&two) == ["a", "b"]);
    assert_eq!(two[0].active.values, [1.5]);
    close(two[1].active.values[0], fit(10.0, 1.0, 2.5).1);
}
