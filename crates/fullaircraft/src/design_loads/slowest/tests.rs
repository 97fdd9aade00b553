//! Words on the slowest of roots made by hand.

use super::slowest_words;
use faer::c64;
use std::f64::consts::{LN_2, TAU};

#[test]
fn the_slowest_motion_is_the_one_nearest_to_growing_among_those_that_decay() {
    // 3 % of critical damping at 2 Hz: p = w (-0.03 + i sqrt(1 - 0.03²)), its frequency the imaginary part's
    let w = 2.0 * TAU / (1.0_f64 - 0.0009).sqrt();
    let slow = c64::new(-0.03 * w, 2.0 * TAU);
    let fast = c64::new(-9.0, 40.0);
    for roots in
        [vec![slow, fast], vec![fast, slow.conj(), c64::new(0.5, 3.0)], vec![c64::new(-1e-9, 5.0), slow]]
    {
        let words = slowest_words(&roots);
        assert!(words.contains("at 2.000 Hz 3.0000 % of critical damping"), "{words}");
    }
    let words = slowest_words(&[c64::new(-LN_2 / 8.0, 0.0), fast]);
    assert!(words.contains("without oscillation takes 8 s to halve"), "{words}");
    for roots in [vec![], vec![c64::new(0.1, 2.0)], vec![c64::new(0.0, 0.0), c64::new(-1e-8, 1.0)]] {
        assert_eq!(slowest_words(&roots), "no motion decays");
    }
}
