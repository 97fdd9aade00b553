//! What amplifiers, servos and mechanisms do to sampled signals.

use crate::rig::Actuator;

/// The signal a time later (negative: earlier), by cubic interpolation; before its first sample it rests there.
pub(super) fn delayed(values: &[f64], time_step_s: f64, delay_s: f64) -> Vec<f64> {
    let shift = delay_s / time_step_s;
    let whole = shift.floor();
    let t = 1.0 - (shift - whole);
    let last = values.len().saturating_sub(1);
    let at = |i: f64| {
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped to the record")]
        let place = i.clamp(0.0, last as f64) as usize;
        values[place]
    };
    // between the samples i - whole - 1 and i - whole, at the share t
    (0..values.len())
        .map(|i| {
            let k = i as f64 - whole - 1.0;
            let [a, b, c, d] = [at(k - 1.0), at(k), at(k + 1.0), at(k + 2.0)];
            if t >= 1.0 {
                // a whole number of samples: to the last bit
                return c;
            }
            let (first, third) = (0.5 * (c - a), a - 2.5 * b + 2.0 * c - 0.5 * d);
            b + t * (first + t * (third + t * (0.5 * (d - a) + 1.5 * (b - c))))
        })
        .collect()
}

/// A first order lag, exact for signals that are straight between samples, at rest before the first.
pub(super) fn first_order(values: &[f64], time_step_s: f64, time_constant_s: f64) -> Vec<f64> {
    if time_constant_s <= 0.0 {
        return values.to_vec();
    }
    let x = time_step_s / time_constant_s;
    let decay = (-x).exp();
    // weights of the old and the new input over a step
    let gain = if x > 1e-8 { (1.0 - decay) / x } else { 1.0 - 0.5 * x };
    let mut state = values.first().copied().unwrap_or(0.0);
    let mut before = state;
    values
        .iter()
        .map(|&now| {
            state = decay * state + (gain - decay) * before + (1.0 - gain) * now;
            before = now;
            state
        })
        .collect()
}

/// Largest half phase of a natural frequency in a time step: what is faster is late by less than a twentieth of a step.
const FASTEST: f64 = 14.0;

/// A second order low pass of Butterworth.
pub(super) fn second_order(values: &[f64], time_step_s: f64, corner_hz: f64) -> Vec<f64> {
    let butterworth = Actuator { frequency_hz: corner_hz, damping_ratio: std::f64::consts::FRAC_1_SQRT_2 };
    damped(values, time_step_s, butterworth)
}

/// The low pass of second order that a servo is, by the bilinear transform: slow motions are as late as they are behind the continuous one,
/// whatever its natural frequency is beside the sample rate. (With the natural frequency put in place a filter of 30 Hz at 100 samples a second
/// would be late by half of that.)
pub(super) fn damped(values: &[f64], time_step_s: f64, servo: Actuator) -> Vec<f64> {
    let w = (std::f64::consts::PI * servo.frequency_hz * time_step_s).min(FASTEST);
    let damping = 2.0 * servo.damping_ratio * w;
    let scale = 1.0 / (1.0 + damping + w * w);
    let (b, a1, a2) = (w * w * scale, 2.0 * (w * w - 1.0) * scale, (1.0 - damping + w * w) * scale);
    let first = values.first().copied().unwrap_or(0.0);
    let (mut x1, mut x2, mut y1, mut y2) = (first, first, first, first);
    values
        .iter()
        .map(|&x| {
            let y = b * (x + 2.0 * x1 + x2) - a1 * y1 - a2 * y2;
            (x2, x1, y2, y1) = (x1, x, y1, y);
            y
        })
        .collect()
}

/// No faster than a rate.
pub(super) fn rate_limited(values: &[f64], time_step_s: f64, largest_rate: f64) -> Vec<f64> {
    let step = largest_rate * time_step_s;
    let mut state = values.first().copied().unwrap_or(0.0);
    values
        .iter()
        .map(|&now| {
            state += (now - state).clamp(-step, step);
            state
        })
        .collect()
}

/// Freeplay: the output follows once half the gap is used up.
pub(super) fn freeplay(values: &[f64], gap: f64) -> Vec<f64> {
    let mut state = values.first().copied().unwrap_or(0.0);
    values
        .iter()
        .map(|&now| {
            state = state.clamp(now - 0.5 * gap, now + 0.5 * gap);
            state
        })
        .collect()
}

#[cfg(test)]
mod laws;

#[cfg(test)]
mod tests {
    use super::*;

    fn sine(f_hz: f64, dt: f64) -> Vec<f64> {
        (0..400).map(|i| (std::f64::consts::TAU * f_hz * f64::from(i) * dt).sin()).collect()
    }

    #[test]
    fn a_delayed_sine_is_the_sine_of_an_earlier_time_and_no_delay_changes_no_bit() {
        let dt = 0.01;
        let values = sine(4.0, dt);
        assert_eq!(delayed(&values, dt, 0.0), values);
        for delay in [0.004, -0.0137, 0.03] {
            let later = delayed(&values, dt, delay);
            for (i, value) in later.iter().enumerate().take(390).skip(10) {
                let exact = (std::f64::consts::TAU * 4.0 * (i as f64 * dt - delay)).sin();
                assert!((value - exact).abs() < 2e-3, "{delay} {i}: {value} {exact}");
            }
        }
    }

    #[test]
    fn a_lag_of_first_order_turns_a_ramp_into_the_same_ramp_later() {
        let ramp: Vec<f64> = (0..500).map(|i| f64::from(i) * 0.01).collect();
        let lagged = first_order(&ramp, 0.01, 0.05);
        assert!((lagged[499] - (ramp[499] - 0.05)).abs() < 1e-9, "{}", lagged[499]);
        assert_eq!(first_order(&ramp, 0.01, 0.0), ramp);
    }

    #[test]
    fn a_low_pass_is_three_decibels_down_at_its_corner() {
        let filtered = second_order(&sine(5.0, 0.005), 0.005, 5.0);
        let peak = filtered[200..].iter().copied().fold(0.0, f64::max);
        assert!((peak - std::f64::consts::FRAC_1_SQRT_2).abs() < 0.01, "{peak}");
    }

    #[test]
    fn freeplay_and_a_rate_limit_follow_a_triangle_as_drawn() {
        assert_eq!(freeplay(&[0.0, 1.0, 2.0, 1.0, 0.0], 1.0), [0.0, 0.5, 1.5, 1.5, 0.5]);
        assert_eq!(rate_limited(&[0.0, 1.0, 1.0, 1.0], 0.5, 1.0), [0.0, 0.5, 1.0, 1.0]);
        let sine = sine(2.0, 0.01);
        assert_eq!(freeplay(&sine, 0.0), sine);
    }
}
