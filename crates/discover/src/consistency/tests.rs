//! Shares and their scatter on groups worked out by hand.

use super::*;
use crate::by_hand::{ByHand, made, size};
use crate::rules::EffectRule;
use maneuver::effects::{Calibrated, Calibration, Parameter};

fn share(share: f64, sigma: f64) -> Share {
    Share { v_m_s: 30.0, moved: Moved::Pitch, share, sigma }
}

#[test]
fn equal_shares_do_not_scatter_and_opposite_ones_do() {
    assert_eq!(spread(&[&share(1.0, 0.1), &share(1.0, 0.2)], 0.15), Some(0.0));
    assert_eq!(spread(&[&share(1.0, 0.1)], 0.15), None);
    // (1.5 - 0.5)² / (2 (0.1² + 0.15²)) by hand
    let apart = spread(&[&share(1.5, 0.1), &share(0.5, 0.1)], 0.15).expect("two shares");
    assert!((apart - 1.0 / (2.0 * 0.0325)).abs() < 1e-9, "{apart}");
}

#[test]
fn shares_that_agree_with_each_other_and_not_with_the_size_found_are_no_size_of_it() {
    let same = [-0.81, -0.83, -0.75, -0.69].map(|value| share(value, 0.1));
    let off = spread(&same.iter().collect::<Vec<_>>(), 0.15).expect("shares");
    // (1 + 0.77)² / (0.1²/4 + 0.15²) by hand
    assert!((off - 1.77_f64.powi(2) / 0.025).abs() < 1e-9, "{off}");
}

#[test]
fn words_are_those_of_the_maneuvers() {
    assert_eq!(
        [Moved::Nothing, Moved::Pitch, Moved::Surfaces].map(Moved::word),
        ["static", "pitch", "surfaces"]
    );
}

#[test]
fn shares_weigh_by_their_own_variance_and_that_of_the_form() {
    // variances 0.3² + 0.4² = 0.25 twice and 0.6² + 0.4² = 0.52
    let three = [share(0.2, 0.3), share(1.4, 0.3), share(2.0, 0.6)];
    let (w, v) = (4.0, 1.0 / 0.52);
    let mean = (4.0 * 1.6 + v * 2.0) / (2.0 * w + v);
    let square =
        4.0 * ((0.2 - mean) * (0.2 - mean) + (1.4 - mean) * (1.4 - mean)) + v * (2.0 - mean) * (2.0 - mean);
    let chi2 = spread(&three.iter().collect::<Vec<_>>(), 0.4).expect("three shares");
    assert!((chi2 - square / 2.0).abs() < 1e-12, "{chi2}");
    // all alike and twice too large: one over 1/(1/0.3² + 1/0.6²) + 0.4² = 0.072 + 0.16
    let twice = [share(2.0, 0.3), share(2.0, 0.6)];
    let off = spread(&[&twice[0], &twice[1]], 0.4).expect("two shares");
    assert!((off - 1.0 / 0.232).abs() < 1e-12, "{off}");
}

#[test]
fn the_form_is_that_of_the_effect_and_of_the_variants() {
    let mut one = Parameter::new("size", -9.0..=9.0, 1.0);
    one.calibrated = Some(Calibrated { by: Calibration::Mass, sigma: 0.03 });
    let open = made("open", &[], size()).active(&[0.5]);
    let known = made("known", &[], vec![one]).active(&[-0.5]);
    let mut rules = Rules::default();
    let sized = EffectRule { form: 0.3, off_by_variants: OffByVariants::Size(0.02) };
    rules.effects.own.insert("sized".to_owned(), sized);
    let free = EffectRule { form: 0.1, off_by_variants: OffByVariants::Nothing };
    rules.effects.own.insert("free".to_owned(), free);
    let two = [share(1.5, 0.1), share(0.5, 0.1)];
    // (1.5 - 0.5)² / (2 (σ² + form²)), form with 2.5 standard deviations over the size beside it
    let is = |rules: &Rules, effect: &Active, form: f64, off: f64| {
        let chi2 = scatter(rules, effect, &two).expect("two shares");
        let by_hand = 0.5 / (0.01 + form * form + off * off);
        assert!((chi2 - by_hand).abs() < 1e-9, "{chi2} {by_hand}");
    };
    is(&rules, &open, 0.15, 0.0);
    is(&rules, &known, 0.15, 2.5 * 0.03 / 0.5);
    is(&rules, &made("sized", &[], size()).active(&[-0.4]), 0.3, 2.5 * 0.02 / 0.4);
    is(&rules, &made("free", &[], size()).active(&[0.01]), 0.1, 0.0);
    // never more than the model's form may be off by
    is(&rules, &made("sized", &[], size()).active(&[0.01]), 0.3, 0.2);
    rules.consistency.form_most = 0.05;
    is(&rules, &made("sized", &[], size()).active(&[0.01]), 0.3, 0.05);
}

#[test]
fn what_holds_at_rest_only_is_judged_at_rest_only() {
    let mut rest = made("rest", &[], size());
    rest.at_rest_only = true;
    let still = |value: f64| Share { moved: Moved::Nothing, ..share(value, 0.1) };
    let rules = Rules::default();
    let mixed = [share(9.0, 0.1), still(1.0), still(1.0), share(-7.0, 0.1)];
    assert_eq!(scatter(&rules, &rest.active(&[1.0]), &mixed), Some(0.0));
    assert_eq!(scatter(&rules, &rest.active(&[1.0]), &mixed[2..]), None);
    let always = made("always", &[], size()).active(&[1.0]);
    assert!(scatter(&rules, &always, &mixed).is_some_and(|chi2| chi2 > 100.0));
    let moving = [share(1.0, 0.1), share(1.0, 0.1)];
    assert_eq!(scatter(&rules, &always, &moving), Some(0.0));
    assert_eq!(scatter(&rules, &rest.active(&[1.0]), &moving), None);
}

#[test]
fn segments_go_by_airspeed_and_what_moved() {
    let point: &[f64] = &[0.0, 0.0];
    let known = ByHand::new(&[point; 6])
        .moving(1, 1, &[0.1, 0.104])
        .moving(2, 1, &[0.1, 0.103])
        .moving(3, 1, &[0.2, 0.1])
        // as much as is allowed is no pitch yet
        .moving(4, 0, &[0.0, 0.0035])
        .moving(5, 0, &[-0.0036, 0.0]);
    let groups: Vec<_> = groups(&known.setting(), &known.problem()).into_iter().collect();
    let expected = [
        ((0, Moved::Nothing), vec![0]),
        ((0, Moved::Pitch), vec![5]),
        ((0, Moved::Surfaces), vec![4]),
        ((1, Moved::Pitch), vec![1, 3]),
        ((1, Moved::Surfaces), vec![2]),
    ];
    assert_eq!(groups, expected);
}

/// Two groups of one column, c = (3, 4 | 10, 0) at a size of two; each has what is left of it, r. With nothing shared a
/// group has `1 + c'r / (1 + c'c)` for its share.
#[test]
fn a_share_is_what_a_group_alone_would_add() {
    let planted = |more: [f64; 4]| {
        let [a, b, c, d] = [3.0, 4.0, 10.0, 0.0];
        let (one, two) = ([a + more[0], b + more[1]], [c + more[2], d + more[3]]);
        ByHand::new(&[&one, &two]).column(made("one", &[], size()), &[1.5, 2.0, 5.0, 0.0])
    };
    let of =
        |known: &ByHand| shares(&known.setting(), &known.model(&[known.active("one", &[2.0])]).strict(0), 0);
    let open = |known: ByHand| known.ruled(|rules| rules.consistency.known_share = 9.0);
    // residuals (0.3, -0.1 | 0.5, 0.7) are noise: phi is one
    let known = open(planted([0.3, -0.1, 0.5, 0.7]));
    let [one, two] = of(&known)[..] else { panic!("two groups") };
    assert!((one.v_m_s - 10.0).abs() < 1e-12 && (two.v_m_s - 20.0).abs() < 1e-12);
    assert!((one.share - 1.0 - 0.5 / 26.0).abs() < 1e-9 && (two.share - 1.0 - 5.0 / 101.0).abs() < 1e-9);
    assert!((one.sigma - 26.0_f64.sqrt().recip()).abs() < 1e-9);
    assert!((two.sigma - 101.0_f64.sqrt().recip()).abs() < 1e-9);
    // what is not explained makes all uncertain: phi of (9 + 1 + 25 + 49)/4 = 21
    let known = open(planted([3.0, 1.0, 5.0, 7.0]));
    let [one, two] = of(&known)[..] else { panic!("two groups") };
    assert!((one.share - 1.0 - 13.0 / 26.0).abs() < 1e-9 && (two.share - 1.0 - 50.0 / 101.0).abs() < 1e-9);
    assert!((one.sigma - (21.0_f64 / 26.0).sqrt()).abs() < 1e-9);
    assert!((two.sigma - (21.0_f64 / 101.0).sqrt()).abs() < 1e-9);
}

/// A shared column g = (0, 1 | 1, 0) leaves of an inner product `a'b - a'g b'g/3`.
#[test]
fn what_is_shared_ties_groups_together() {
    let known = ByHand::new(&[&[3.3, 3.9], &[10.5, 0.7]])
        .ruled(|rules| rules.consistency.known_share = 9.0)
        .column(made("one", &[], size()), &[1.5, 2.0, 5.0, 0.0])
        .uncertain(&[0.0, 1.0, 1.0, 0.0]);
    let current = known.model(&[known.active("one", &[2.0])]).strict(0);
    let [one, two] = shares(&known.setting(), &current, 0)[..] else { panic!("two groups") };
    let (a, b, ab) = (1.0 + 25.0 - 16.0 / 3.0, 1.0 + 100.0 - 100.0 / 3.0, -40.0 / 3.0);
    // r = (0.3, -0.1 | 0.5, 0.7), g'r = 0.4
    let (ar, br) = (0.5 - 4.0 * 0.4 / 3.0, 5.0 - 10.0 * 0.4 / 3.0);
    let determinant = a * b - ab * ab;
    assert!((one.share - 1.0 - (b * ar - ab * br) / determinant).abs() < 1e-9, "{one:?}");
    assert!((two.share - 1.0 - (a * br - ab * ar) / determinant).abs() < 1e-9, "{two:?}");
    assert!((one.sigma - (b / determinant).sqrt()).abs() < 1e-9);
    assert!((two.sigma - (a / determinant).sqrt()).abs() < 1e-9);
}

#[test]
fn groups_that_know_a_size_badly_are_left_out() {
    // standard deviations of 1/√(1 + c²): 0.05, 0.1, 0.2 nearly
    let (c, size_of) = ([20.0, 10.0, 5.0], |v: f64| 1.0 / v.hypot(1.0));
    let of = |known_share: f64, times_worse: f64| {
        let known = ByHand::new(&[&[c[0]], &[c[1]], &[c[2]]])
            .ruled(|rules| {
                rules.consistency.known_share = known_share;
                rules.consistency.times_worse = times_worse;
            })
            .column(made("one", &[], size()), &c);
        shares(&known.setting(), &known.model(&[known.active("one", &[1.0])]).strict(0), 0)
    };
    let all = of(0.25, 10.0);
    assert_eq!(all.len(), 3);
    assert!(all.iter().zip(c).all(|(share, c)| (share.sigma - size_of(c)).abs() < 1e-12), "{all:?}");
    // two and a half times the best is 0.125
    assert_eq!(of(0.25, 2.5), all[..2]);
    assert_eq!(of(0.15, 10.0), all[..2]);
    // as badly as is allowed is too badly
    assert_eq!(of(all[2].sigma, 10.0), all[..2]);
}
