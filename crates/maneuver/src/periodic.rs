//! Records as one period of a periodic signal: continued beyond their end until all is at rest again, and filtered.

use faer::c64;
use fourier::fast_length;
use std::f64::consts::{PI, TAU};

/// How long a signal that was filtered has to come to rest, s.
const FILTERED_REST_S: f64 = 1.0;
/// How long drives take to return, s.
pub(crate) const RETURN_S: f64 = 1.0;

/// Samples behind a linear filter, given by its response at an angular frequency (rad/s); at rest before the first.
pub(crate) fn filtered(values: &[f64], time_step_s: f64, response: impl Fn(f64) -> c64) -> Vec<f64> {
    if values.iter().all(|value| *value == values[0]) {
        return values.to_vec();
    }
    let length = fast_length(values.len() + steps(RETURN_S + FILTERED_REST_S, time_step_s));
    let mut spectrum: Vec<c64> = continued(values, length, time_step_s).into_iter().map(c64::from).collect();
    fourier::forward(&mut spectrum);
    let step_rad_s = TAU / (length as f64 * time_step_s);
    for bin in 0..=length / 2 {
        let factor = response(bin as f64 * step_rad_s);
        if 2 * bin == length {
            spectrum[bin] *= factor.re;
        } else {
            spectrum[bin] *= factor;
            if bin > 0 {
                spectrum[length - bin] *= factor.conj();
            }
        }
    }
    fourier::backward(&mut spectrum);
    let scale = 1.0 / length as f64;
    spectrum[..values.len()].iter().map(|value| values[0] + scale * value.re).collect()
}

#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a positive number of steps")]
pub(crate) fn steps(length: f64, step: f64) -> usize {
    (length / step).round() as usize
}

/// The change from the first sample, brought back to zero after the last.
pub(crate) fn continued(values: &[f64], length: usize, time_step_s: f64) -> Vec<f64> {
    let (first, last) = (values[0], values[values.len() - 1]);
    let back = steps(RETURN_S, time_step_s).max(1);
    (0..length)
        .map(|i| match i.checked_sub(values.len()) {
            None => values[i] - first,
            Some(beyond) if beyond < back => {
                (last - first) * 0.5 * (1.0 + (PI * (beyond + 1) as f64 / back as f64).cos())
            }
            Some(_) => 0.0,
        })
        .collect()
}

#[cfg(test)]
mod tests;
