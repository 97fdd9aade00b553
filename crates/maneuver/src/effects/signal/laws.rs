//! Filters and mechanisms against closed forms.

use super::*;
use std::f64::consts::{PI, TAU};

#[test]
fn a_parabola_is_delayed_exactly_and_a_pulse_by_catmull_and_rom_s_weights() {
    let (dt, f) = (0.02, |t: f64| 1.0 - 3.0 * t + 2.0 * t * t);
    let values: Vec<f64> = (0..20).map(|k| f(f64::from(k) * dt)).collect();
    for delay in [0.3 * dt, 1.8 * dt, -0.25 * dt, -2.6 * dt] {
        let later = delayed(&values, dt, delay);
        for (k, later) in later.iter().enumerate().take(15).skip(5) {
            let exact = f(k as f64 * dt - delay);
            assert!((later - exact).abs() < 1e-12, "{delay} {k}: {later} {exact}");
        }
    }
    let pulse: Vec<f64> = (0..9).map(|k| f64::from(u8::from(k == 4))).collect();
    let half = delayed(&pulse, 1.0, 0.5);
    assert_eq!(half, [0.0, 0.0, 0.0, -0.0625, 0.5625, 0.5625, -0.0625, 0.0, 0.0]);
    // a quarter later: (-9, 111, 29, -3)/128 at the shares 1/4 and 3/4
    let quarter = delayed(&pulse, 1.0, 0.25).map_to_128();
    assert_eq!(quarter, [0.0, 0.0, 0.0, -9.0, 111.0, 29.0, -3.0, 0.0, 0.0]);
}

trait Scaled {
    fn map_to_128(self) -> Vec<f64>;
}

impl Scaled for Vec<f64> {
    fn map_to_128(self) -> Vec<f64> {
        self.into_iter().map(|x| 128.0 * x).collect()
    }
}

#[test]
fn whole_steps_of_delay_move_samples_and_ends_are_kept() {
    let values = [1.0, 4.0, 2.0, 7.0];
    assert_eq!(delayed(&values, 0.5, 0.5), [1.0, 1.0, 4.0, 2.0]);
    assert_eq!(delayed(&values, 0.5, 1.5), [1.0, 1.0, 1.0, 1.0]);
    assert_eq!(delayed(&values, 0.5, -1.0), [2.0, 7.0, 7.0, 7.0]);
    assert!(delayed(&[], 0.5, 0.25).is_empty());
}

/// `x + sum of slope changes times the answer to a ramp`, for a signal that is straight between samples.
fn lagged(values: &[f64], dt: f64, tau: f64) -> Vec<f64> {
    let ramp = |t: f64| if t > 0.0 { t - tau * -(-t / tau).exp_m1() } else { 0.0 };
    let slope = |k: usize| if k + 1 < values.len() { (values[k + 1] - values[k]) / dt } else { 0.0 };
    (0..values.len())
        .map(|i| {
            let change = |k: usize| slope(k) - if k > 0 { slope(k - 1) } else { 0.0 };
            values[0] + (0..i).map(|k| change(k) * ramp((i - k) as f64 * dt)).sum::<f64>()
        })
        .collect()
}

#[test]
fn a_first_order_lag_is_exact_for_what_is_straight_between_samples() {
    let values: Vec<f64> = (0..40).map(|k| 0.4 + (1.9 * f64::from(k)).sin()).collect();
    for tau in [0.001, 0.02, 0.3, 5.0] {
        let (ours, wanted) = (first_order(&values, 0.02, tau), lagged(&values, 0.02, tau));
        assert!(ours.iter().zip(&wanted).all(|(a, b)| (a - b).abs() < 1e-11), "{tau}");
    }
    for tau in [0.0, -0.1] {
        assert_eq!(first_order(&values, 0.02, tau), values);
    }
    assert!(first_order(&[], 0.02, 0.1).is_empty());
    // a lag of a thousand million steps: half a step of the jump's ramp, then whole ones
    for x in [1e-9, 1e-6] {
        let slow = first_order(&[0.0, 1.0, 1.0, 1.0], x, 1.0);
        for (value, steps) in slow.iter().zip([0.0, 0.5, 1.5, 2.5]) {
            assert!((value - steps * x).abs() < 1e-4 * x, "{x}: {value}");
        }
    }
}

/// Amplitude and phase of the last whole periods.
fn swing(values: &[f64], omega_dt: f64, last: usize) -> (f64, f64) {
    let sum = |of: fn(f64) -> f64| -> f64 {
        let range = values.len() - last..values.len();
        range.map(|k| values[k] * of(omega_dt * k as f64)).sum::<f64>() * 2.0 / last as f64
    };
    (sum(f64::sin), sum(f64::cos))
}

#[test]
fn a_servo_in_samples_is_the_analogue_one_with_its_frequencies_bent_by_tangents() {
    for (servo, dt) in [
        (Actuator { frequency_hz: 5.0, damping_ratio: 0.6 }, 0.01),
        (Actuator { frequency_hz: 3.0, damping_ratio: 0.3 }, 0.02),
        (Actuator { frequency_hz: 80.0, damping_ratio: 0.7 }, 0.01),
        // so fast that it is held
        (Actuator { frequency_hz: 800.0, damping_ratio: 0.7 }, 0.01),
    ] {
        let place = (PI * servo.frequency_hz * dt).min(14.0);
        for f in [1.0, 5.0, 12.5] {
            let omega_dt = TAU * f * dt;
            let values: Vec<f64> = (0..3000).map(|k| (omega_dt * f64::from(k)).sin()).collect();
            let r = (0.5 * omega_dt).tan() / place;
            let (re, im) = (1.0 - r * r, 2.0 * servo.damping_ratio * r);
            let size = re * re + im * im;
            let (sin, cos) = swing(&damped(&values, dt, servo), omega_dt, 1000);
            assert!(
                (sin - re / size).abs() < 1e-6 && (cos + im / size).abs() < 1e-6,
                "{servo:?} {f}: {sin} {cos}"
            );
        }
        assert!(damped(&[0.7; 30], dt, servo).iter().all(|x| (x - 0.7).abs() < 1e-12));
    }
    let butterworth = Actuator { frequency_hz: 4.0, damping_ratio: 0.5_f64.sqrt() };
    let values: Vec<f64> = (0..50).map(|k| (0.7 * f64::from(k)).cos()).collect();
    let apart = second_order(&values, 0.01, 4.0)
        .iter()
        .zip(damped(&values, 0.01, butterworth))
        .map(|(a, b)| a - b)
        .fold(0.0, |most: f64, x| most.max(x.abs()));
    assert!(apart < 1e-12, "{apart:e}");
    // the first value of a step from rest is b/(a_0), the same by hand
    let w = PI * 0.04;
    let step = second_order(&[0.0, 1.0], 0.01, 4.0);
    assert!((step[1] - w * w / (1.0 + 2.0_f64.sqrt() * w + w * w)).abs() < 1e-12);
}

#[test]
fn rates_are_limited_both_ways_and_freeplay_follows_behind_half_its_gap() {
    assert_eq!(
        rate_limited(&[1.0, 3.0, -4.0, -4.0, -4.0, -2.75], 0.5, 3.0),
        [1.0, 2.5, 1.0, -0.5, -2.0, -2.75]
    );
    assert_eq!(freeplay(&[1.0, -1.0, -0.5, 0.5, 3.0], 1.0), [1.0, -0.5, -0.5, 0.0, 2.5]);
    assert!(rate_limited(&[], 0.5, 1.0).is_empty() && freeplay(&[], 1.0).is_empty());
}
