//! Draws of segments with winners that can be counted.

use super::*;
use crate::by_hand::{ByHand, Made, made, ranked, size};

/// Three segments of twenty rows.
fn segments() -> ByHand {
    ByHand::new(&[&[0.0; 20], &[0.0; 20], &[0.0; 20]])
}

/// Squares of the residual by segment.
fn fit(made: &Made, evidence: f64, squares: [f64; 3]) -> Ranked {
    let mut residual = vec![0.0; 60];
    for (segment, square) in squares.into_iter().enumerate() {
        residual[20 * segment] = f64::sqrt(square);
    }
    ranked(&made.active(&[1.0]), evidence, &residual)
}

/// A leads by 1, 3 and 7. Each of the others wins where its segment is drawn twice, and then by 0.2: half of what it saves
/// there is 1.2, 3.2 and 7.2. `scale` is that of all squares.
fn four(scale: f64) -> Vec<Ranked> {
    let all = [
        ("a", [0.0; 3], 10.0),
        ("b", [2.4, 0.0, 0.0], 9.0),
        ("c", [0.0, 6.4, 0.0], 7.0),
        ("d", [0.0, 0.0, 14.4], 3.0),
    ];
    let rivals = |name: &str| -> &'static [&'static str] { if name == "b" { &["a"] } else { &[] } };
    let one = |(name, saved, evidence): (&'static str, [f64; 3], f64)| {
        fit(&made(name, rivals(name), size()), evidence, saved.map(|saved| scale * (20.0 - saved)))
    };
    all.map(one).to_vec()
}

fn rules() -> RivalRules {
    RivalRules { draws: 4000, in_set: 0.05, close: 0.5, close_share: 0.0, form_share: 0.0, rival_share: 0.5 }
}

fn drawn(rules: &RivalRules, ranked: &[Ranked], best: usize) -> Draws {
    distinguish(rules, &segments().bare(), ranked, &ranked[best], 7)
}

/// Of the 27 ways to draw three of three segments, 7 draw a given one at least twice, and 6 draw each once.
#[test]
fn candidates_win_as_often_as_their_segments_are_drawn() {
    let own = |scale: f64, which: usize| drawn(&rules(), &four(scale), which).own;
    let shares = [0, 1, 2, 3].map(|which| own(1.0, which));
    for (share, ways) in shares.into_iter().zip([6.0, 7.0, 7.0, 7.0]) {
        assert!((share - ways / 27.0).abs() < 0.035, "{shares:?}");
    }
    assert!((shares.iter().sum::<f64>() - 1.0).abs() < 1e-12);
    // with a chi square a row of 2.5 squares count less by as much
    let ranked: Vec<Ranked> = four(2.5);
    assert!((ranked[0].refit.chi2 - 150.0).abs() < 1e-9);
    let a = drawn(&rules(), &ranked, 0).own;
    assert!((a - 6.0 / 27.0).abs() < 0.035, "{a}");
    // with a fifth less they win where a segment is drawn three times only
    let weak = four(2.0).into_iter().enumerate().map(|(which, mut one)| {
        if which == 0 {
            let short: f64 = 30.0;
            one.refit.residual[1] = short.sqrt();
            one.refit.residual[21] = short.sqrt();
            one.refit.residual[41] = short.sqrt();
        } else {
            for at in [1, 21, 41] {
                one.refit.residual[at] = 30.0_f64.sqrt();
            }
        }
        one.refit.chi2 += 90.0;
        one
    });
    let weak: Vec<Ranked> = weak.collect();
    let a = drawn(&rules(), &weak, 0).own;
    assert!((a - 24.0 / 27.0).abs() < 0.035, "{a}");
}

#[test]
fn close_and_winning_rivals_are_in_the_set() {
    let ranked = four(1.0);
    let set = |change: &dyn Fn(&mut RivalRules)| {
        let mut rules = rules();
        change(&mut rules);
        drawn(&rules, &ranked, 0).confused_with
    };
    // those that win and have half of the best one's evidence
    assert_eq!(set(&|_| ()), ["b", "c"]);
    assert_eq!(set(&|rules| rules.rival_share = 0.1), ["b", "c", "d"]);
    // not with just as much as is asked for: 0.9 of ten
    assert_eq!(set(&|rules| rules.rival_share = 0.7), ["b"]);
    // who wins seldom is in the set if it is close: within 1, within 3 and more, and within a quarter of ten
    let rare = |close: f64, close_share: f64| {
        set(&|rules| {
            rules.in_set = 0.9;
            rules.close = close;
            rules.close_share = close_share;
        })
    };
    assert!(rare(0.5, 0.0).is_empty() && rare(1.0, 0.0).is_empty());
    assert_eq!(rare(1.5, 0.0), ["b"]);
    assert_eq!(rare(0.0, 0.25), ["b"]);
    assert_eq!(rare(0.0, 0.5), ["b", "c"]);
    assert_eq!(rare(8.0, 0.25), ["b", "c", "d"]);
}

#[test]
fn rivals_of_the_library_count_beside_the_best() {
    let ranked = four(1.0);
    let rules = rules();
    let [a, b, c, d] = [0, 1, 2, 3].map(|which| drawn(&rules, &ranked, which).own);
    let plausible = a + b + c;
    let is = |best: usize, own: f64, with_rivals: f64| {
        let draws = drawn(&rules, &ranked, best);
        assert!((draws.own - own).abs() < 1e-12, "{draws:?} {own}");
        assert!((draws.with_rivals - with_rivals).abs() < 1e-12, "{draws:?} {with_rivals}");
    };
    // b is a rival of a; c is none; d has too little to be anything beside another
    is(0, a, (a + b) / plausible);
    is(1, b, (a + b) / plausible);
    is(2, c, c / plausible);
    // what is named counts however little it has, and so does all that has more than half of that
    is(3, d, d);
}

#[test]
fn forms_of_one_effect_are_one_name() {
    let mut ranked = four(1.0);
    let [a, b, c] = [0, 1, 2].map(|which| drawn(&rules(), &ranked, which).own);
    // c is another form of b
    let form = fit(&made("b", &["a"], size()).formed("other"), 7.0, [20.0, 13.6, 20.0]);
    ranked[2] = form;
    let draws = drawn(&rules(), &ranked, 0);
    assert_eq!(draws.confused_with, ["b"]);
    assert!((draws.own - a).abs() < 1e-12 && (draws.with_rivals - 1.0).abs() < 1e-12, "{draws:?}");
    assert!((drawn(&rules(), &ranked, 1).own - b - c).abs() < 1e-12);
}

#[test]
fn evidence_of_the_share_exactly_is_not_enough() {
    // half of the best one's is five: d has it, and wins
    let mut ranked = four(1.0);
    ranked[3] = fit(&made("d", &[], size()), 5.0, [20.0, 20.0, 5.6]);
    let [a, b, c] = [0, 1, 2].map(|which| drawn(&rules(), &ranked, which).own);
    let draws = drawn(&rules(), &ranked, 0);
    assert_eq!(draws.confused_with, ["b", "c"]);
    assert!((draws.with_rivals - (a + b) / (a + b + c)).abs() < 1e-12, "{draws:?}");
}

#[test]
fn where_nothing_plausible_wins_no_share_is_left() {
    let winner = fit(&made("a", &[], size()), 10.0, [1.0; 3]);
    let second = fit(&made("b", &[], size()), 9.0, [1.0; 3]);
    let rules = RivalRules { rival_share: 2.0, ..rules() };
    let draws = drawn(&rules, &[winner, second], 1);
    assert!(draws.own.abs() < 1e-12 && draws.with_rivals.abs() < 1e-12, "{draws:?}");
}
