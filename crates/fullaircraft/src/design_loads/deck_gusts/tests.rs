//! What gusts on a deck are made with: frequencies of the air, modes among roots, the highest frequency of a case.

use super::{FREQUENCIES, frequencies_of_air, highest_rad_s, stable};
use crate::design_loads::search::tests::{case, discrete, turbulence};
use faer::c64;
use loads::design::Direction;
use loads::matrix::Action;
use std::f64::consts::{LN_2, PI};

#[test]
fn frequencies_of_the_air_rise_as_the_power_of_three_halves_to_the_highest() {
    // a gust's phase turns by highest times half the length: 0.7 rad a frequency at the upper end, whose step is 1.5
    // highest/count
    let all = frequencies_of_air(2.0, 13.9);
    assert_eq!(all.len(), 60, "1.5 x 2 x 13.9/0.7, rounded up");
    assert!(
        (all[59] - 2.0).abs() < 1e-14 && (all[14] - 2.0 / 8.0).abs() < 1e-14,
        "a quarter of the way: 1/8"
    );
    assert!(all.windows(2).all(|pair| pair[0] < pair[1]) && all[0] > 0.0);
    assert_eq!(frequencies_of_air(2.0, 14.1).len(), 61, "rounded up");
    assert_eq!([frequencies_of_air(1e-3, 1.0).len(), frequencies_of_air(1e3, 1.0).len()], [16, 96]);
    assert_eq!(FREQUENCIES, [16.0, 96.0]);
}

#[test]
fn roots_that_grow_say_how_fast_they_double_and_narrow_ones_are_modes() {
    let narrow = c64::new(-1.0, 5.0);
    let roots = [narrow, narrow.conj(), c64::new(-1.3, 5.0), c64::new(-2.0, 0.0), c64::new(1e-7, 0.0)];
    let modes = stable(&roots).expect("none grows: zero found twice is a small pair");
    assert_eq!(modes.len(), 1, "a decay of less than a quarter of its frequency");
    assert_eq!((modes[0].omega_rad_s, modes[0].decay_rad_s), (5.0, 1.0));
    let growing = [narrow, c64::new(0.2, 3.0), c64::new(0.5, 0.0)];
    assert!((stable(&growing).expect_err("two grow") - LN_2 / 0.5).abs() < 1e-14, "the fastest");
    // growth of less than a millionth of a root's size is none
    assert!(stable(&[c64::new(4e-6, 5.0)]).is_ok());
    assert!(stable(&[c64::new(6e-6, 5.0)]).is_err());
    assert!(stable(&[]).expect("none").is_empty());
}

#[test]
fn a_case_needs_eight_harmonics_of_its_gust_or_turbulence_up_to_its_cut_off() {
    // of a gust of 2 H: 2 pi V/(2 H) a harmonic
    let law = 8.0 * 2.0 * PI * 50.0 / 30.0;
    assert!((highest_rad_s(&discrete(1, 15.0, Direction::Up)) - law).abs() < 1e-12);
    assert!((highest_rad_s(&turbulence(1)) - 40.0 * PI).abs() < 1e-12);
    assert_eq!(highest_rad_s(&case(1, Action::Trim)), 0.0);
}
