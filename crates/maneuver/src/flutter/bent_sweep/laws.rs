//! Pairs by hand.

use super::*;

#[test]
fn the_nearest_pairs_are_taken_first_and_none_is_farther_than_the_limit() {
    let pairs = vec![(0.3, 0, 0), (0.1, 0, 1), (0.05, 1, 1), (0.2, 2, 2), (0.4, 0, 2)];
    assert_eq!(matched(3, pairs.clone(), 0.3), [Some(0), Some(1), Some(2)]);
    assert_eq!(matched(3, pairs.clone(), 0.29), [None, Some(1), Some(2)]);
    assert_eq!(matched(3, pairs, 0.01), [None; 3]);
}

#[test]
fn a_root_is_another_one_beyond_a_quarter_of_the_larger_modulus() {
    let root = |re: f64, im: f64| Some(c64::new(re, im));
    assert_eq!(nearest(&[root(0.0, 100.0)], &[root(0.0, 75.1)]), [root(0.0, 75.1)]);
    assert_eq!(nearest(&[root(0.0, 100.0)], &[root(0.0, 74.9)]), [None]);
    assert_eq!(nearest(&[root(0.0, 75.1)], &[root(0.0, 100.0)]), [root(0.0, 100.0)]);
    assert_eq!(nearest(&[root(0.0, 74.9), None], &[root(0.0, 100.0), None]), [None, None]);
}
