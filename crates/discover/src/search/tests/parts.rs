//! Effects judged from parts of the data.

use super::*;
use crate::by_hand::found;

/// Two airspeeds of sixteen points: half of them measure a, with one size, and half of them b, with another at each.
pub(super) fn parts(a: [f64; 2], b: [f64; 2]) -> ByHand {
    let all = steps(&[(0..8, a[0]), (8..16, b[0]), (16..24, a[1]), (24..32, b[1])]);
    let (one, two) = all.split_at(16);
    ByHand::new(&[one, two])
        .column(made("a", &[], size()), &steps(&[(0..8, 1.0), (16..24, 1.0)]))
        .column(made("b", &[], size()), &steps(&[(8..16, 1.0), (24..32, 1.0)]))
}

/// Shares of 1 ± d with `d = 8·2.5·1/(1 + 8·2.5²)` have a scatter of `(2 d)²/(2 (σ² + 0.15²))`,
/// `σ² = 1/(1 + 8·2.5²)`.
#[test]
fn an_effect_whose_parts_disagree_is_dropped_and_with_the_first_all() {
    let known = parts([4.0, 4.0], [3.5, 1.5]);
    let values = [("a", 4.0), ("b", 2.5)].map(|(name, size)| known.active(name, &[size]));
    let judged = |limit: f64, order: [usize; 2]| {
        let effects = order.map(|which| values[which].clone());
        let found = effects.iter().map(|active| found(active, 50.0, &[])).collect();
        let mut outcome = Outcome { found, ..Outcome::default() };
        let dropped = judge_parts(&known.setting(), &known.model(&effects), limit, &mut outcome);
        (dropped, outcome)
    };
    let off = 20.0 / 51.0;
    let scattered = 4.0 * off * off / (2.0 * (1.0 / 51.0 + 0.15 * 0.15));
    let (dropped, all) = judged(1.001 * scattered, [0, 1]);
    assert!(!dropped && all.names() == ["a", "b"] && all.trace.is_empty());
    let by_hand = [("a", [1.0, 1.0], 129.0), ("b", [1.0 + off, 1.0 - off], 51.0)];
    for (found, (name, shares, information)) in all.found.iter().zip(by_hand) {
        assert_eq!((found.name(), found.shares.len()), (name, 2));
        for (own, share) in found.shares.iter().zip(shares) {
            close(own.share, share);
            close(own.sigma, f64::sqrt(1.0 / information));
        }
    }
    let (dropped, one) = judged(0.999 * scattered, [0, 1]);
    assert!(dropped && one.names() == ["a"] && one.trace.len() == 1);
    // as much as is allowed is not too much
    let rules = known.setting().rules().clone();
    let exactly = scatter(&rules, &all.found[1].active, &all.found[1].shares).expect("two shares");
    close(exactly, scattered);
    assert!(!judged(exactly, [0, 1]).0 && judged(exactly * (1.0 - 1e-12), [0, 1]).0);
    // what was found beside a wrong effect is not to be believed
    let (dropped, none) = judged(0.999 * scattered, [1, 0]);
    assert!(dropped && none.found.is_empty() && none.trace.len() == 1);
    let (dropped, all) = judged(1.001 * scattered, [1, 0]);
    assert!(!dropped && all.names() == ["b", "a"]);
    // nothing was found, nothing is dropped
    let mut nothing = Outcome::default();
    assert!(!judge_parts(&known.setting(), &known.bare(), 0.0, &mut nothing));
}
