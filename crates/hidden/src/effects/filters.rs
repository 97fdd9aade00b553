//! Lags, delays and low passes of sampled signals that are at rest before their first sample.

use std::f64::consts::PI;

/// A first-order lag, exact for inputs that run linearly between samples.
pub(super) fn lag(values: &mut [f64], lag_s: f64, time_step_s: f64) {
    let Some(&first) = values.first() else { return };
    let h = time_step_s / lag_s;
    let keep = (-h).exp();
    // of the sample before and of this one
    let now = 1.0 - (1.0 - keep) / h;
    let before = (1.0 - keep) / h - keep;
    let (mut input, mut state) = (first, first);
    for value in values.iter_mut().skip(1) {
        state = keep * state + before * input + now * *value;
        input = *value;
        *value = state;
    }
}

/// A signal `steps` later (not a whole number, earlier if negative): cubic interpolation of Lagrange.
pub(super) fn delayed(values: &[f64], steps: f64) -> Vec<f64> {
    let Some(last) = values.len().checked_sub(1) else { return Vec::new() };
    let at = |place: f64| values[index(place).min(last)];
    (0..values.len())
        .map(|i| {
            let place = i as f64 - steps;
            let (below, t) = (place.floor(), place - place.floor());
            let [a, b, c, d] = [-1.0, 0.0, 1.0, 2.0].map(|k| at(below + k));
            a * (-t * (t - 1.0) * (t - 2.0) / 6.0)
                + b * ((t + 1.0) * (t - 1.0) * (t - 2.0) / 2.0)
                + c * (-(t + 1.0) * t * (t - 2.0) / 2.0)
                + d * ((t + 1.0) * t * (t - 1.0) / 6.0)
        })
        .collect()
}

/// The index at a place, zero before the beginning.
fn index(place: f64) -> usize {
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "not negative, and a record is short"
    )]
    let index = place.max(0.0) as usize;
    index
}

/// Butterworth's low pass of four poles: two sections of second order, bilinear with the cutoff kept in place.
pub(super) fn butterworth_4(values: &mut [f64], cutoff_hz: f64, time_step_s: f64) {
    // beyond the simulation's own Nyquist frequency there is nothing to cut
    let warped = (PI * cutoff_hz.min(0.49 / time_step_s) * time_step_s).tan();
    for angle in [PI / 8.0, 3.0 * PI / 8.0] {
        second_order(values, warped, 2.0 * angle.cos());
    }
}

/// `w² / (s² + damping w s + w²)` by the bilinear transformation.
fn second_order(values: &mut [f64], w: f64, damping: f64) {
    let Some(&first) = values.first() else { return };
    let norm = 1.0 / (1.0 + damping * w + w * w);
    let gain = w * w * norm;
    let (a1, a2) = (2.0 * (w * w - 1.0) * norm, (1.0 - damping * w + w * w) * norm);
    let (mut x, mut y) = ([first; 2], [first; 2]);
    for value in values {
        let next = gain * (*value + 2.0 * x[0] + x[1]) - a1 * y[0] - a2 * y[1];
        (x, y) = ([*value, x[0]], [next, y[0]]);
        *value = next;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

    const STEP_S: f64 = 0.0025;

    fn ramp() -> Vec<f64> {
        (0..2000).map(|i| f64::from(i) * STEP_S).collect()
    }

    #[test]
    fn ramps_come_out_late_by_the_stated_times() {
        let mut lagged = ramp();
        lag(&mut lagged, 0.03, STEP_S);
        assert!((ramp()[1999] - lagged[1999] - 0.03).abs() < 1e-9);
        let late = delayed(&ramp(), 0.0123 / STEP_S);
        assert!((ramp()[1500] - late[1500] - 0.0123).abs() < 1e-9);
        // 2.613 / w, as tabulated for four poles
        let mut passed = ramp();
        butterworth_4(&mut passed, 5.0, STEP_S);
        let late_s = ramp()[1999] - passed[1999];
        assert!((late_s - 2.6131 / (TAU * 5.0)).abs() < 2e-4, "{late_s}");
    }

    #[test]
    fn the_low_pass_is_three_decibels_down_at_its_cutoff() {
        let mut wave: Vec<f64> = (0..8000).map(|i| (TAU * 5.0 * f64::from(i) * STEP_S).sin()).collect();
        butterworth_4(&mut wave, 5.0, STEP_S);
        let top = wave[4000..].iter().copied().fold(0.0, f64::max);
        assert!((top - 0.5_f64.sqrt()).abs() < 2e-3, "{top}");
    }

    #[test]
    fn a_smooth_wave_is_shifted_without_losing_height() {
        let wave: Vec<f64> = (0..400).map(|i| (TAU * 4.0 * f64::from(i) * STEP_S).sin()).collect();
        let early = delayed(&wave, -2.4);
        for (i, shifted) in early.iter().enumerate().take(380).skip(10) {
            let exact = (TAU * 4.0 * (i as f64 + 2.4) * STEP_S).sin();
            assert!((shifted - exact).abs() < 1e-5);
        }
    }
}
