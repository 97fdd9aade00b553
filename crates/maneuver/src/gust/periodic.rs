//! The answer of a linear system to a periodic signal, by a Fourier series.
//!
//! ```text
//! y(t) = sum_n H(omega_n) U_n exp(i omega_n t),   omega_n = 2 pi n/T
//! ```
//! Samples of one period; harmonics above the highest frequency given (or half the sampling rate) are left out and their share
//! of the signal is reported.

use faer::c64;
use std::f64::consts::TAU;

/// One period of answers.
#[derive(Debug, Clone)]
pub struct Periodic {
    /// A list of samples for each answer.
    pub answers: Vec<Vec<f64>>,
    /// Root mean square of the harmonics left out over that of the signal.
    pub left_out: f64,
}

/// One period of the answers `answer(omega)` (per amplitude one, omega in rad/s from 0) to a signal given by the
/// samples of one period.
///
/// # Errors
/// What `answer` reports.
pub fn periodic_response<E>(
    signal: &[f64],
    time_step_s: f64,
    highest_rad_s: f64,
    mut answer: impl FnMut(f64) -> Result<Vec<c64>, E>,
) -> Result<Periodic, E> {
    let n = signal.len();
    // exp(2 pi i k/n), from which every harmonic takes its steps
    let circle: Vec<c64> =
        (0..n).map(|k| TAU * k as f64 / n as f64).map(|a| c64::new(a.cos(), a.sin())).collect();
    let base = TAU / (n as f64 * time_step_s);
    let mut answers: Vec<Vec<f64>> = Vec::new();
    let (mut kept, mut all) = (0.0, 0.0);
    for harmonic in 0..=n / 2 {
        let turn = |k: usize| circle[(harmonic * k) % n];
        let sum: c64 = signal.iter().enumerate().map(|(k, value)| turn(k).conj() * *value).sum();
        let both_sides = if harmonic == 0 || 2 * harmonic == n { 1.0 } else { 2.0 };
        let amplitude = sum * (both_sides / n as f64);
        all += amplitude.norm_sqr();
        let omega = base * harmonic as f64;
        if omega > highest_rad_s {
            continue;
        }
        kept += amplitude.norm_sqr();
        let values = answer(omega)?;
        answers.resize_with(values.len(), || vec![0.0; n]);
        for (list, value) in answers.iter_mut().zip(values) {
            let amplitude = value * amplitude;
            for (k, sample) in list.iter_mut().enumerate() {
                *sample += (amplitude * turn(k)).re;
            }
        }
    }
    let left_out = if all > 0.0 { ((all - kept).max(0.0) / all).sqrt() } else { 0.0 };
    Ok(Periodic { answers, left_out })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_does_nothing_gives_the_signal_back_and_a_delay_delays_it() {
        let n = 64;
        let signal: Vec<f64> = (0..n).map(|k| (-0.02 * f64::from(k - 20).powi(2)).exp()).collect();
        let step = 0.1;
        let respond = |delay: f64| {
            let h = |omega: f64| Ok::<_, ()>(vec![c64::new((omega * delay).cos(), -(omega * delay).sin())]);
            periodic_response(&signal, step, 1e9, h).unwrap()
        };
        let same = respond(0.0);
        assert!(same.left_out < 1e-12);
        assert!(same.answers[0].iter().zip(&signal).all(|(a, b)| (a - b).abs() < 1e-12));
        let later = respond(3.0 * step);
        assert!((3..64).all(|k| (later.answers[0][k] - signal[k - 3]).abs() < 1e-9));
    }

    #[test]
    fn a_first_order_lag_answers_as_in_closed_form() {
        // y' = -a y + u with u = 1 + cos(omega t)
        let (n, step, a) = (200, 0.05, 0.7);
        let omega = TAU / (200.0 * step) * 3.0;
        let signal: Vec<f64> = (0..n).map(|k| 1.0 + (omega * step * f64::from(k)).cos()).collect();
        let h = |omega: f64| Ok::<_, ()>(vec![c64::new(1.0, 0.0) / c64::new(a, omega)]);
        let got = periodic_response(&signal, step, 1e9, h).unwrap();
        for (k, value) in got.answers[0].iter().enumerate() {
            let t = step * k as f64;
            let want =
                1.0 / a + (a * (omega * t).cos() + omega * (omega * t).sin()) / (a * a + omega * omega);
            assert!((value - want).abs() < 1e-9, "{t}");
        }
        let cut = periodic_response(&signal, step, 0.5 * omega, h).unwrap();
        assert!(cut.left_out > 0.5);
    }
}
