//! Candidates of columns that share no row, whose gains and evidence have closed forms.

use super::*;
use crate::by_hand::{ByHand, Made, made, ranked, size};
use crate::rules::RankRules;
use maneuver::effects::Parameter;

#[test]
fn what_is_ranked_goes_by_name_form_and_number_of_parameters() {
    let one = || Parameter::new("one", -1.0..=1.0, 1.0);
    let values = [1.0; 2];
    let pair = ranked(&made("lag", &[], vec![one(), one()]).formed("late").active(&values), 30.0, &[]);
    assert_eq!((pair.name(), pair.label(), pair.parameters()), ("lag", "lag late".to_owned(), 2));
}

#[test]
fn what_counts_has_more_than_it_needs_and_is_itself_and_no_matter_of_calibration() {
    let rules = SharedRules::default();
    let mut own = made("one", &[], size());
    let one = |made: &Made, value: f64| ranked(&made.active(&[value]), 30.0, &[]);
    assert!(one(&own, 1.0).counts(29.0, &rules));
    assert!(!one(&own, 1.0).counts(30.0, &rules));
    assert!(!one(&own, 1.0).counts(31.0, &rules));
    // a hundredth of the plausible is nothing
    assert!(!one(&own, 0.01).counts(29.0, &rules));
    assert!(!one(&own, 0.01).counts(31.0, &rules));
    own.itself = false;
    assert!(!one(&own, 1.0).counts(29.0, &rules));
    assert!(!one(&own, 0.01).counts(29.0, &rules));
}

/// Four columns on four rows with `I = 1` each: a measured m lets the misfit with the prior fall by `m²/2`.
fn four(measured: [f64; 4], rules: RankRules) -> ByHand {
    let mut known = ByHand::new(&[&measured]).ruled(|all| all.rank = rules);
    for (which, name) in ["a", "b", "c", "d"].into_iter().enumerate() {
        let mut column = [0.0; 4];
        column[which] = 1.0;
        known = known.column(made(name, &[], size()), &column);
    }
    known
}

fn rule(shown: usize, fitted: usize, fitted_share: f64, least_gain: f64) -> RankRules {
    RankRules { fitted, fitted_share, least_gain, shown }
}

fn names(known: &ByHand) -> Vec<&'static str> {
    let all = rank(&known.setting(), &known.bare(), &known.nulls(25.0, 1.5));
    assert!(all.windows(2).all(|pair| pair[0].evidence >= pair[1].evidence));
    let mut names: Vec<&str> = all.iter().map(Ranked::name).collect();
    names.sort_unstable();
    names
}

/// Gains of 200, 98, 50 and 18.
#[test]
fn the_promising_candidates_are_fitted() {
    let of = |rules: RankRules| names(&four([10.0, 20.0, 14.0, 6.0], rules));
    assert_eq!(of(rule(9, 0, 1.0, 1e9)), ["a", "b", "c", "d"]);
    // so many are shown all the same
    assert_eq!(of(rule(2, 0, 1.0, 1e9)), ["b", "c"]);
    assert!(of(rule(0, 9, 0.0, 1e9)).is_empty());
    // so many are fitted if they gain enough
    assert_eq!(of(rule(0, 2, 9.0, 20.0)), ["b", "c"]);
    assert_eq!(of(rule(0, 9, 9.0, 20.0)), ["a", "b", "c"]);
    assert_eq!(of(rule(0, 9, 9.0, 60.0)), ["b", "c"]);
    // and all within a share of the best one
    assert_eq!(of(rule(0, 0, 0.4, 20.0)), ["b", "c"]);
    assert_eq!(of(rule(0, 0, 0.2, 20.0)), ["a", "b", "c"]);
    assert_eq!(of(rule(0, 1, 0.2, 20.0)), ["a", "b", "c"]);
    // the best one is no more than itself
    assert!(of(rule(0, 0, 1.0, 20.0)).is_empty());
    // as much as is asked for is not more
    let known = four([10.0, 20.0, 14.0, 6.0], rule(0, 9, 0.0, 20.0));
    let gain = Screened::new(&known.setting(), &known.bare(), known.effect("c")).gain;
    assert!((gain - 98.0).abs() < 1e-9);
    assert_eq!(of(rule(0, 9, 0.0, gain)), ["b"]);
    assert_eq!(of(rule(0, 9, 0.0, 0.999 * gain)), ["b", "c"]);
}

/// `(chi²_0 - chi²_e)/(2 phi) - prior/2 - ½ ln(1 + I/phi)`, phi what the best one leaves of each row.
#[test]
fn evidence_is_by_what_the_best_one_leaves() {
    let known = four([10.0, 20.0, 14.0, 6.0], RankRules::default());
    let all = rank(&known.setting(), &known.bare(), &known.nulls(25.0, 1.5));
    // b at ten leaves 100 of 400
    let phi = (732.0 - 300.0) / 4.0;
    assert!(all.len() >= 3);
    for one in &all {
        let m: f64 = match one.name() {
            "a" => 10.0,
            "b" => 20.0,
            "c" => 14.0,
            _ => 6.0,
        };
        let evidence = 0.75 * m * m / (2.0 * phi) - m * m / 8.0 - 0.5 * (1.0 / phi).ln_1p();
        assert!((one.evidence - evidence).abs() < 1e-6, "{} {} {evidence}", one.name(), one.evidence);
        assert!((one.threshold - 25.0).abs() < 1e-12);
    }
    // phi is never less than one
    let known = four([2.0, 0.1, 0.1, 0.1], RankRules::default());
    let all = rank(&known.setting(), &known.bare(), &known.nulls(25.0, 1.5));
    assert!((all[0].evidence - (1.5 - 0.5 - 0.5 * 2.0_f64.ln())).abs() < 1e-6, "{}", all[0].evidence);
}

#[test]
fn what_the_model_has_is_not_ranked_nor_what_is_not_wanted() {
    let known = four([10.0, 20.0, 14.0, 6.0], rule(9, 9, 0.0, 0.0));
    let (setting, nulls) = (known.setting(), known.nulls(25.0, 1.5));
    let current = known.model(&[known.active("b", &[10.0])]);
    let of = |wanted: &[&str]| {
        let some = rank_some(&setting, &current, &nulls, &|name| wanted.contains(&name), &[]);
        let mut names: Vec<&str> = some.iter().map(Ranked::name).collect();
        names.sort_unstable();
        names
    };
    assert_eq!(of(&["a", "b", "c", "d"]), ["a", "c", "d"]);
    assert_eq!(of(&["b", "d"]), ["d"]);
    assert!(of(&["b"]).is_empty());
}

/// What was found before is fitted again however little it gains: in its own form, and no other.
#[test]
fn a_known_effect_is_fitted_again_in_its_form() {
    let one = || made("one", &[], size());
    let known = ByHand::new(&[&[1.0, 1.0, 30.0]])
        .ruled(|all| all.rank = rule(0, 0, 0.5, 20.0))
        .column(one(), &[1.0, 0.0, 0.0])
        .column(one().formed("other"), &[0.0, 1.0, 0.0])
        .column(made("two", &[], size()).formed("other"), &[0.0, 0.5, 0.0]);
    let (setting, current, nulls) = (known.setting(), known.bare(), known.nulls(25.0, 1.5));
    let of = |again: &[&Active]| -> Vec<String> {
        let some = rank_some(&setting, &current, &nulls, &|_| true, again);
        some.iter().map(Ranked::label).collect()
    };
    assert!(of(&[]).is_empty());
    assert_eq!(of(&[&one().formed("other").active(&[0.5])]), ["one other"]);
    assert_eq!(of(&[&one().active(&[0.5])]), ["one "]);
}
