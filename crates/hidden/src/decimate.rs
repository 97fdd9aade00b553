//! From the simulation's step to a written run: a low pass without ringing, then one sample of several.
//!
//! The kernel is a Gaussian of 4.4 ms (3 dB down at 30 Hz), symmetric: no delay. What is commanded passes it
//! as the loads do, as it would in one data acquisition.

use crate::design::STEPS_PER_SAMPLE;

/// Standard deviation of the kernel, steps of the simulation.
const WIDTH_STEPS: f64 = 1.77;
/// Steps to either side.
const REACH: usize = 7;

/// Weights from the middle outwards, with sum one over the whole kernel.
fn weights() -> [f64; REACH + 1] {
    let plain: [f64; REACH + 1] = std::array::from_fn(|k| (-0.5 * (k as f64 / WIDTH_STEPS).powi(2)).exp());
    let sum = plain[0] + 2.0 * plain[1..].iter().sum::<f64>();
    plain.map(|weight| weight / sum)
}

/// Filtered samples; the record goes on with its first and last value.
pub(crate) fn decimated(values: &[f64]) -> Vec<f64> {
    let Some(last) = values.len().checked_sub(1) else { return Vec::new() };
    let weights = weights();
    let at = |middle: usize| {
        let pair = |k: usize| values[middle.saturating_sub(k)] + values[(middle + k).min(last)];
        weights[0] * values[middle] + (1..=REACH).map(|k| weights[k] * pair(k)).sum::<f64>()
    };
    (0..=last).step_by(STEPS_PER_SAMPLE).map(at).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

    #[test]
    fn slow_signals_pass_and_thirty_hertz_lose_three_decibels() {
        let gain = |hz: f64| {
            let wave: Vec<f64> = (0..4001).map(|i| (TAU * hz * f64::from(i) / 400.0).cos()).collect();
            let passed = decimated(&wave);
            // the middle of the record, where the wave is at its top
            passed[500]
        };
        assert!((gain(1.0) - 1.0).abs() < 1e-3);
        assert!((gain(30.0) - 0.5_f64.sqrt()).abs() < 0.01);
    }

    #[test]
    fn a_constant_stays_what_it_is() {
        assert!(decimated(&[3.0; 21]).iter().all(|value| (value - 3.0).abs() < 1e-14));
    }
}
