//! Answers in time: what frequencies stand for, a Fourier series of equal ones, and what they leave out.

use super::{Waves, remarks, shares};
use faer::c64;
use std::f64::consts::{PI, TAU};

#[test]
fn frequencies_stand_for_half_the_way_to_their_neighbours() {
    assert_eq!(shares(&[2.0]), vec![2.0]);
    // 1, 2, 4, 9: from 0.5 to 1.5, 3, 6.5 and as far beyond the last as before it
    assert_eq!(shares(&[1.0, 2.0, 4.0, 9.0]), vec![1.0, 1.5, 3.5, 5.0]);
    // none below zero: rest counts from zero on
    assert_eq!(shares(&[0.0, 2.0, 4.0]), vec![1.0, 2.0, 2.0]);
    assert_eq!(shares(&[0.25, 2.25, 4.25]), vec![1.25, 2.0, 2.0]);
}

/// Transform of exp(-2 t) from zero on.
fn decay(hz: f64) -> c64 {
    c64::from(1.0) / c64::new(2.0, TAU * hz)
}

#[test]
fn the_sum_over_frequencies_is_the_inverse_transform() {
    // 2 exp(-2 t) cos... : amplitudes of t exp(-2 t), which is smooth enough for a finite band
    let hz: Vec<f64> = (0..4000).map(|i| 0.05 * f64::from(i)).collect();
    let times = [0.3, 0.8, 2.0];
    let amplitudes: Vec<c64> = hz.iter().map(|hz| decay(*hz) * decay(*hz)).collect();
    let found = Waves::new(&hz, &times).summed(&amplitudes);
    for (t, found) in times.into_iter().zip(found) {
        assert!((found - t * (-2.0 * t).exp()).abs() < 2e-4, "{t} s: {found}");
    }
}

/// Frequencies an eighth of a Hz apart, and the transform of a wave at one of them through their period of eight
/// seconds.
fn wave(count: u32, from: u32, at: u32) -> (Vec<f64>, Vec<c64>) {
    let hz: Vec<f64> = (from..count).map(|i| 0.125 * f64::from(i)).collect();
    let transform = (from..count).map(|i| c64::from(if i == at { 4.0 } else { 0.0 }));
    (hz.clone(), transform.collect())
}

#[test]
fn nothing_is_said_of_a_wave_at_one_of_the_frequencies_within_a_period() {
    let (hz, transform) = wave(20, 0, 7);
    let value = |t: f64| (TAU * 0.875 * t).cos();
    assert_eq!(remarks(&hz, &transform, &[0.0, 7.9], &value), Vec::<String>::new());
    let late = remarks(&hz, &transform, &[0.0, 8.1], &value);
    assert!(late.len() == 1 && late[0].contains("repeat their answer every 8 s"), "{late:?}");
    assert!(late[0].contains("before the last time 8.1 s"), "{late:?}");
}

#[test]
fn what_frequencies_miss_is_said_as_a_share_of_the_root_mean_square() {
    // sin + 0.5 sin of three times the frequency: without the second sqrt(0.25/1.25) = 45 % is missing
    let (hz, transform) = wave(20, 0, 7);
    let value = |t: f64| (TAU * 0.875 * t).cos() + 0.5 * (TAU * 2.625 * t).cos();
    let said = remarks(&hz, &transform, &[0.0], &value);
    assert!(said.len() == 1 && said[0].starts_with("45 % of the excitation"), "{said:?}");
    assert!(said[0].contains("beyond 2.375 Hz"), "{said:?}");
    // a constant beside: at zero it counts, and is missed
    let value = |t: f64| (TAU * 0.875 * t).cos() + 1.0;
    let said = remarks(&hz, &transform, &[0.0], &value);
    assert!(said.len() == 1 && said[0].starts_with("82 % of"), "sqrt(1/1.5): {said:?}");
}

#[test]
fn without_a_frequency_of_zero_answers_have_no_mean_which_matters_if_the_excitation_has_one() {
    let (hz, transform) = wave(20, 1, 7);
    let said = remarks(&hz, &transform, &[0.0], &|t| (TAU * 0.875 * t).cos());
    assert!(said.len() == 1 && said[0].contains("no frequency of zero"), "{said:?}");
    assert!(said[0].contains("period of 8.0000 s") && !said[0].contains("begin FREQ"), "{said:?}");
    let said = remarks(&hz, &transform, &[0.0], &|t| (TAU * 0.875 * t).cos() - 0.01);
    assert!(!said[0].contains("begin FREQ"), "1.4 %: {said:?}");
    let said = remarks(&hz, &transform, &[0.0], &|t| (TAU * 0.875 * t).cos() - 0.1);
    assert!(said.len() == 1 && said[0].contains("begin FREQ at zero"), "{said:?}");
    assert_eq!(remarks(&[1.0], &[c64::from(1.0)], &[0.0], &|_| PI).len(), 1, "one frequency is none");
}
