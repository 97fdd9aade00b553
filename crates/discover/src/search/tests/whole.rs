//! A search from its beginning to its end.

use super::parts::parts;
use super::*;

fn searched<'a>(known: &'a ByHand, nulls: &NullDistribution) -> (Outcome, CurrentModel<'a>) {
    let (outcome, current) = search(&known.setting(), known.problem(), nulls, 1);
    // the model is the one with what was found
    let effects: Vec<&str> = current.effects.iter().map(|active| active.effect.spec().name).collect();
    assert_eq!(effects, outcome.names());
    for (active, found) in current.effects.iter().zip(&outcome.found) {
        assert_eq!(active.values, found.active.values);
    }
    close(outcome.misfit[1], current.chi2 / 32.0);
    (outcome, current)
}

#[test]
fn what_is_found_ends_with_its_size_and_misfits_by_row() {
    let known = columns(4.0, 0.0, 5.0);
    let (outcome, _) = searched(&known, &known.nulls(20.0, 1.5));
    assert_eq!(outcome.names(), ["a"]);
    close(outcome.found[0].active.values[0], 3.75);
    close(outcome.misfit[0], (240.0 + 25.0) / 32.0);
    close(outcome.misfit[1], (240.0 / 256.0 + 25.0) / 32.0);
    assert!(!outcome.unexplained);
    assert_eq!(outcome.first_ranking.len(), 2);
    assert_eq!(outcome.next_best.map(|next| next.name()), Some("b"));
}

/// c is nearly a: it stays beside it. b was as close at first, and was found: it does not.
#[test]
fn what_was_found_beside_an_effect_is_no_rival_of_it() {
    let known = columns(4.0, 3.9, 1.0).column(made("c", &[], size()), &steps(&[(0..14, 1.0)]));
    let (outcome, _) = searched(&known, &known.nulls(5.0, 1.5));
    assert_eq!(outcome.names(), ["a", "b"]);
    let one = &outcome.found[0];
    assert_eq!(one.considered, ["a", "b", "c"]);
    assert_eq!(one.confused_with, ["c"]);
    let rivals: Vec<&str> = one.rivals.iter().map(|rival| rival.active.effect.spec().name).collect();
    assert_eq!(rivals, ["c"]);
    assert!(outcome.found[1].confused_with.is_empty() && !outcome.unexplained);
    // one at most
    let known = columns(4.0, 3.9, 1.0).ruled(|rules| {
        rules.naming.most_effects = 1;
        rules.naming.explained_by_all = 0.1;
    });
    let (outcome, _) = searched(&known, &known.nulls(5.0, 1.5));
    assert_eq!(outcome.names(), ["a"]);
    assert_eq!(outcome.found[0].confused_with, ["b"]);
    assert!(outcome.unexplained);
}

/// Of 340 a explains 240 but for a 256th of it; 16 or 64 are where nothing is missing.
#[test]
fn effects_that_explain_too_little_together_are_not_named() {
    let found = |by_all: f64, misfit: f64, misfit_limit: f64| {
        let known = columns(4.0, 0.0, 10.0).ruled(|rules| rules.naming.explained_by_all = by_all);
        let nulls = NullDistribution { misfit, ..known.nulls(20.0, misfit_limit) };
        let (outcome, _) = searched(&known, &nulls);
        close(outcome.misfit[0], 340.0 / 32.0);
        if outcome.found.is_empty() {
            assert!(outcome.unexplained);
            close(outcome.misfit[1], 340.0 / 32.0);
        } else {
            assert_eq!(outcome.names(), ["a"]);
            close(outcome.misfit[1], (240.0 / 256.0 + 100.0) / 32.0);
        }
        !outcome.found.is_empty()
    };
    for misfit in [0.5, 2.0] {
        let explained = (240.0 - 240.0 / 256.0) / (340.0 - 32.0 * misfit);
        assert!(found(0.999 * explained, misfit, 1.5));
        assert!(!found(1.001 * explained, misfit, 1.5));
        // where no more is left than may be it does not matter
        assert!(found(1.001 * explained, misfit, 4.0));
        assert!(found(9.0, misfit, 4.0));
    }
    // what is left to the bit
    let known = columns(4.0, 0.0, 10.0);
    let nulls = known.nulls(20.0, 1.5);
    let mut one = so_far(&known, &nulls);
    assert!(one.step(&known.setting()));
    let left = one.current.chi2 / 32.0;
    close(left, (240.0 / 256.0 + 100.0) / 32.0);
    assert!(found(9.0, 0.5, left));
    assert!(!found(9.0, 0.5, left * (1.0 - 1e-12)));
    // all that is missing is as much as is asked for
    assert!(found(1.0, left, 1.5));
    assert!(!found(1.0 + 1e-12, left, 1.5));
}

/// b alone has another size at each airspeed: its shares scatter by 7.7.
#[test]
fn what_only_resembles_is_left_out_of_the_model() {
    let of = |scatter: f64, misfit_limit: f64| {
        let known = parts([4.0, 4.0], [3.5, 1.5]).ruled(|rules| {
            rules.consistency.scatter = scatter;
            rules.consistency.scatter_unexplained = scatter;
        });
        searched(&known, &known.nulls(5.0, misfit_limit)).0
    };
    let a_left = 256.0 / (17.0 * 17.0);
    let b = 8.0 * (3.5 * 3.5 + 1.5 * 1.5);
    let both = of(8.0, 1.5);
    assert_eq!(both.names(), ["a", "b"]);
    let fitted = 40.0 / 17.0;
    let b_left = 8.0 * ((3.5 - fitted) * (3.5 - fitted) + (1.5 - fitted) * (1.5 - fitted));
    close(both.misfit[0], (256.0 + b) / 32.0);
    close(both.misfit[1], (a_left + b_left) / 32.0);
    assert!(!both.unexplained);
    let one = of(7.0, 1.5);
    assert_eq!(one.names(), ["a"]);
    close(one.misfit[1], (a_left + b) / 32.0);
    assert!(one.unexplained);
    // what was dropped leaves doubts where nothing else was found
    assert!(!of(7.0, 4.0).unexplained);
}

/// A size of 6 and of 4 at two airspeeds scatters by more than three.
#[test]
fn parts_must_agree_better_where_something_is_left() {
    let of = |scatter: f64, scatter_unexplained: f64, misfit_limit: f64| {
        let known = parts([6.0, 4.0], [0.0, 0.0]).ruled(|rules| {
            rules.consistency.scatter = scatter;
            rules.consistency.scatter_unexplained = scatter_unexplained;
        });
        let (outcome, _) = searched(&known, &known.nulls(20.0, misfit_limit));
        (outcome.found.len(), outcome.unexplained)
    };
    let (strict, lax) = (1.0, 9.0);
    assert_eq!(of(lax, strict, 20.0), (1, false));
    assert_eq!(of(strict, lax, 0.1), (1, true));
    assert_eq!(of(lax, strict, 0.1), (0, true));
    // nothing is named, though no more is left than may be: it is said
    assert_eq!(of(strict, lax, 20.0), (0, true));
}

#[test]
fn a_misfit_beyond_its_limit_is_unexplained() {
    let known = columns(4.0, 0.0, 4.0);
    let unexplained = |misfit_limit: f64| {
        let (outcome, _) = searched(&known, &known.nulls(1e3, misfit_limit));
        assert!(outcome.found.is_empty() && outcome.trace.is_empty());
        close(outcome.misfit[0], 8.0);
        close(outcome.misfit[1], 8.0);
        outcome.unexplained
    };
    assert!(!unexplained(8.0) && !unexplained(9.0));
    assert!(unexplained(8.0 - 1e-9) && unexplained(1.0));
}

/// What says more than b is not what its name says: which of them it is, nobody knows.
#[test]
fn doubts_count_where_nothing_was_found() {
    let of = |a: f64| {
        let mut stranger = made("stranger", &[], size());
        stranger.itself = false;
        let stranger_column = steps(&[(15..30, 1.0), (31..32, 1.0)]);
        let measured = steps(&[(0..15, a), (15..30, 2.0), (31..32, 2.0)]);
        let known = ByHand::new(&[&measured])
            .column(made("a", &[], size()), &steps(&[(0..15, 1.0)]))
            .column(made("b", &[], size()), &steps(&[(15..30, 1.0)]))
            .column(stranger, &stranger_column);
        let (outcome, _) = searched(&known, &known.nulls(5.0, 9.0));
        assert_eq!(outcome.next_best.as_ref().map(Ranked::name), Some("b"));
        (outcome.names(), outcome.unexplained)
    };
    assert_eq!(of(0.0), (vec![], true));
    assert_eq!(of(6.0), (vec!["a"], false));
}
