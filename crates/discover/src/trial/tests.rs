//! Secants, points and least squares of effects whose loads are written down.

use super::*;
use crate::by_hand::{ByHand, made, size};
use crate::memory::Memory;

fn close(a: &[f64], b: &[f64]) {
    assert!(a.len() == b.len() && a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-9), "{a:?} {b:?}");
}

/// Parameters of both signs, of positive and of negative values; the plausible is not one.
fn bent() -> ByHand {
    let parameters = vec![
        Parameter::new("a", -8.0..=8.0, 2.0),
        Parameter::new("b", 0.0..=4.0, 0.5),
        Parameter::new("c", -4.0..=0.0, 1.0),
    ];
    ByHand::new(&[&[3.0, -1.0, 2.0]]).with(made("bent", &[], parameters), law)
}

/// Squares tell a step to one side from one to the other, and a long one from a short one.
fn law(v: &[f64]) -> Vec<f64> {
    vec![v[0] + v[0] * v[0], v[0] + 3.0 * v[1] + v[1] * v[1], 2.0 * v[0] + v[1] + v[2] - v[2] * v[2]]
}

fn loads(sizes: [f64; 3]) -> Vec<f64> {
    law(&[2.0 * sizes[0], 0.5 * sizes[1], sizes[2]])
}

fn tried<T>(known: &ByHand, name: &str, what: impl FnOnce(&Trial<'_>) -> T) -> T {
    let (setting, current) = (known.setting(), known.bare());
    what(&Trial { setting: &setting, current: &current, effect: known.effect(name), memory: None })
}

#[test]
fn a_point_is_what_bounds_allow_with_its_misfit_and_prior() {
    let known = bent();
    tried(&known, "bent", |trial| {
        assert_eq!(trial.active(&[0.5, 3.0, -0.5]).values, [1.0, 1.5, -0.5]);
        // a of 3.5 is 7, b of 10 is bounded by 4, c by 0
        let point = trial.point(&[3.5, 10.0, 2.0]);
        close(&point.sizes, &[3.5, 8.0, 0.0]);
        let residual = difference(&[3.0, -1.0, 2.0], &loads([3.5, 8.0, 0.0]));
        close(&point.residual, &residual);
        let chi2: f64 = residual.iter().map(|r| r * r).sum();
        assert!((point.chi2 - chi2).abs() < 1e-9);
        assert!((point.score - chi2 - 3.5 * 3.5 - 64.0).abs() < 1e-9);
        let rest = trial.point_at_rest();
        assert_eq!((rest.sizes, rest.residual), (vec![0.0; 3], vec![3.0, -1.0, 2.0]));
        assert!((rest.chi2 - 14.0).abs() < 1e-12 && (rest.score - 14.0).abs() < 1e-12);
    });
    assert_eq!(difference(&[5.0, 2.0], &[3.0, 4.0]), [2.0, -2.0]);
}

/// From nothing a whole plausible size into the bounds; from sizes that are known a fifth of one, back.
#[test]
fn a_secant_is_the_slope_of_a_chord_within_bounds() {
    let known = bent();
    let parameters = known.effect("bent").parameters();
    tried(&known, "bent", |trial| {
        let slope = |k: usize, from: [f64; 3], step: f64| -> Vec<f64> {
            let mut to = from;
            to[k] += step;
            difference(&loads(to), &loads(from)).iter().map(|change| change / step).collect()
        };
        let at = |sizes: [f64; 3]| Base { sizes: sizes.to_vec(), change: loads(sizes) };
        for (k, sign) in [(0, 1.0), (1, 1.0), (2, -1.0)] {
            close(&trial.secant(&parameters, k, &at([0.0; 3])), &slope(k, [0.0; 3], sign));
            let from = [0.5, 2.0, -1.0];
            close(&trial.secant(&parameters, k, &at(from)), &slope(k, from, -0.2 * sign));
        }
    });
}

/// A power of the airspeed does nothing where nothing depends on it: it is tried beside the others at half their size.
#[test]
fn a_parameter_that_does_nothing_alone_is_tried_beside_the_others() {
    let parameters = vec![
        Parameter::new("size", 0.0..=8.0, 1.0),
        Parameter::new("below", -4.0..=0.0, 1.0),
        Parameter::new("above", -4.0..=4.0, 1.0),
    ];
    let product = |v: &[f64]| vec![v[0] * v[1], v[0] * v[2] * (1.0 + v[2]), v[0] * v[1] * v[2]];
    let known = ByHand::new(&[&[0.0; 3]]).with(made("product", &[], parameters), product);
    let parameters = known.effect("product").parameters();
    tried(&known, "product", |trial| {
        let base = Base { sizes: vec![0.0; 3], change: vec![0.0; 3] };
        // from (½, 0, ½) down to (½, -1, ½)
        close(&trial.secant(&parameters, 1, &base), &[0.5, 0.0, 0.25]);
        // from (½, 0, ½) up to (½, 0, 3/2): ½ (15/4 - 3/4)
        close(&trial.secant(&parameters, 2, &base), &[0.0, 1.5, 0.0]);
        // up to (3/2, 0, ½)
        close(&trial.secant(&parameters, 0, &base), &[0.0, 0.75, 0.0]);
    });
}

#[test]
fn secants_around_a_point_are_chords_towards_zero() {
    let known = bent();
    let parameters = known.effect("bent").parameters();
    tried(&known, "bent", |trial| {
        let all = |sizes: [f64; 3], steps: [f64; 3]| {
            let secants = trial.secants_around(&parameters, &trial.point(&sizes));
            assert_eq!((secants.nrows(), secants.ncols()), (3, 3));
            for k in 0..3 {
                let mut to = sizes;
                to[k] += steps[k];
                let slope: Vec<f64> =
                    difference(&loads(to), &loads(sizes)).iter().map(|change| change / steps[k]).collect();
                close(secants.col_as_slice(k), &slope);
            }
        };
        // a tenth of what is not zero, back; a fifth of the plausible into the bounds from what is
        all([1.5, 2.0, -3.0], [-0.15, -0.2, 0.3]);
        all([0.0, 0.0, 0.0], [0.2, 0.2, -0.2]);
        all([-2.0, 0.0, 0.0], [0.2, 0.2, -0.2]);
    });
}

/// The least of `(y - f(x))² + x²`.
#[test]
fn least_squares_end_where_misfit_and_prior_balance() {
    let law = |v: &[f64]| vec![5.0 * v[0] + 0.3 * v[1] * v[1], 4.0 * v[1] + v[0] * v[1]];
    let parameters = ["a", "b"].map(|name| Parameter::new(name, -9.0..=9.0, 1.0)).to_vec();
    let known = ByHand::new(&[&[30.0, -20.0]])
        .ruled(|rules| {
            rules.fit.least_gain = 0.0;
            rules.fit.last_steps = 40;
            rules.fit.last_secant_share = 1e-5;
        })
        .with(made("pair", &[], parameters), law);
    tried(&known, "pair", |trial| {
        let (least, jacobian) = trial.least_squares(&[1.0, 1.0]);
        let score = |a: f64, b: f64| trial.point(&[a, b]).score;
        let (a, b) = (least.sizes[0], least.sizes[1]);
        assert!((least.score - score(a, b)).abs() < 1e-9 && least.score < score(1.0, 1.0) - 500.0);
        for (da, db) in [(1e-2, 0.0), (-1e-2, 0.0), (0.0, 1e-2), (0.0, -1e-2)] {
            assert!(least.score < score(a + da, b + db), "{a} {b}");
        }
        // and the slopes are those there
        let slopes = [[5.0, 0.6 * b], [b, 4.0 + a]];
        assert!((0..2).all(|i| (0..2).all(|j| (jacobian[(i, j)] - slopes[i][j]).abs() < 1e-3)));
    });
}

/// A load that saturates: `y = 40 atan(2x)`.
fn saturating(y: f64, rule: impl FnOnce(&mut crate::rules::FitRules)) -> ByHand {
    ByHand::new(&[&[y]])
        .ruled(|rules| rule(&mut rules.fit))
        .with(made("saturating", &[], size()), |v| vec![40.0 * (2.0 * v[0]).atan()])
}

/// Where the straight line leads too far, half or a quarter of the way is gone.
#[test]
fn a_step_that_leads_too_far_is_halved_twice() {
    let mut shares = Vec::new();
    for near in [0.3, 0.6, 1.0, 1.3, 2.0] {
        let known = saturating(0.0, |fit| fit.last_steps = 1);
        tried(&known, "saturating", |trial| {
            let f = |x: f64| 40.0 * (2.0 * x).atan();
            let slope = (f(near) - f(0.9 * near)) / (0.1 * near);
            let step = (-slope * f(near) - near) / (1.0 + slope * slope);
            let score = |share: f64| {
                let x = near + share * step;
                f(x) * f(x) + x * x
            };
            let share = [1.0, 0.5, 0.25].into_iter().find(|share| score(*share) < score(0.0));
            let reached = near + share.unwrap_or(0.0) * step;
            let (point, _) = trial.least_squares(&[near]);
            assert!((point.sizes[0] - reached).abs() < 1e-9, "{near}: {:?} {reached}", point.sizes);
            shares.push(share);
        });
    }
    assert!([Some(1.0), Some(0.5), Some(0.25)].iter().all(|share| shares.contains(share)), "{shares:?}");
}

/// Three points that measure |x|, the first of them off by seven: from one the straight line leads to minus one, where
/// all is as it was.
#[test]
fn a_step_to_what_is_as_bad_is_halved() {
    let known = ByHand::new(&[&[-6.0, 1.0, 1.0]])
        .ruled(|rules| {
            rules.fit.last_steps = 1;
            rules.fit.last_secant_share = 0.25;
        })
        .with(made("even", &[], size()), |v| vec![v[0].abs(); 3]);
    tried(&known, "even", |trial| {
        close(&[trial.point(&[1.0]).score, trial.point(&[-1.0]).score], &[50.0, 50.0]);
        // (3 + 1) step = 1·(-7) - 1
        let (point, _) = trial.least_squares(&[1.0]);
        close(&point.sizes, &[0.0]);
        assert!((point.score - 38.0).abs() < 1e-9);
    });
}

#[test]
fn steps_end_with_one_that_gains_less_than_is_worth_it() {
    let steps = |near: f64, y: f64, most: usize, least_gain: f64| {
        let known = saturating(y, |fit| {
            fit.last_steps = most;
            fit.least_gain = least_gain;
        });
        tried(&known, "saturating", |trial| trial.least_squares(&[near]).0)
    };
    // far from the end: a first step gains hundreds, and each after it less
    let near = 0.05;
    let start = tried(&saturating(30.0, |_| ()), "saturating", |trial| trial.point(&[near]));
    let [one, two, three] = [1, 2, 3].map(|most| steps(near, 30.0, most, 0.0));
    let [first, second] = [start.score - one.score, one.score - two.score];
    assert!(first > second && second > three.score.mul_add(-1.0, two.score) && second > 0.0);
    let ends = |least_gain: f64| steps(near, 30.0, 3, least_gain).sizes;
    // a gain as large as is asked for is no last one
    assert_eq!(ends(first), two.sizes);
    assert_eq!(ends(first * 1.001), one.sizes);
    assert_eq!(ends(second * 1.001), two.sizes);
    assert_eq!(ends(second), three.sizes);
    // a gain is a difference of misfits: neither their sum nor their ratio
    assert!(start.score / one.score > 1.0 && start.score + one.score > first * 1.001);
}

#[test]
fn what_was_flown_once_is_remembered() {
    let known = bent();
    let (setting, current, memory) = (known.setting(), known.bare(), Memory::default());
    let effect = known.effect("bent");
    let trial = Trial { setting: &setting, current: &current, effect, memory: Some(&memory) };
    let before = known.flights();
    let first = trial.change(&[0.5, 1.0, -1.0]);
    close(&first, &loads([0.5, 1.0, -1.0]));
    assert_eq!(trial.change(&[0.5, 1.0, -1.0]), first);
    assert_eq!(known.flights(), before + 1);
    close(&trial.change(&[0.25, 1.0, -1.0]), &loads([0.25, 1.0, -1.0]));
    assert_eq!(known.flights(), before + 2);
}
