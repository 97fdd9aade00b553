//! Smoothing of measured signals: penalised least squares on third differences.
//!
//! The smooth samples a minimise `sum (y - a)² + lambda sum (third difference of a)²` (Whittaker 1923). In the inside
//! of a record that is a zero-phase low pass `1 / (1 + lambda (2 - 2 cos w)³)` at w rad a sample; lambda is chosen so
//! that it is 3 dB down at the cutoff.

/// Half the number of off-diagonals of the normal equations.
const BAND: usize = 3;
/// Third difference.
const THIRD: [f64; 4] = [-1.0, 3.0, -3.0, 1.0];

/// A smooth signal with its derivatives, one value a sample.
#[derive(Debug, Clone, PartialEq)]
pub struct Smooth {
    /// Values.
    pub value: Vec<f64>,
    /// First derivative, per s.
    pub rate: Vec<f64>,
    /// Second derivative, per s².
    pub second: Vec<f64>,
}

/// Smooths a measured input that is at rest before its first sample, and differentiates the smooth curve.
///
/// The record is continued with its first value to the left and straight on to the right; derivatives are central
/// differences of fourth order, and zero at the first sample, where the run starts from rest.
pub fn smooth_from_rest(values: &[f64], time_step_s: f64, cutoff_hz: f64) -> Smooth {
    let value = whittaker(values, penalty(time_step_s, cutoff_hz), true);
    let last = value.len() - 1;
    let at = |index: isize| match usize::try_from(index) {
        Err(_) => value[0],
        Ok(i) if i <= last => value[i],
        Ok(i) => value[last] + (value[last] - value[last.saturating_sub(1)]) * (i - last) as f64,
    };
    let count = isize::try_from(value.len()).unwrap_or(isize::MAX);
    let mut rate: Vec<f64> = (0..count)
        .map(|i| (at(i - 2) - 8.0 * at(i - 1) + 8.0 * at(i + 1) - at(i + 2)) / (12.0 * time_step_s))
        .collect();
    let mut second: Vec<f64> = (0..count)
        .map(|i| {
            let sum = -at(i - 2) + 16.0 * at(i - 1) - 30.0 * at(i) + 16.0 * at(i + 1) - at(i + 2);
            sum / (12.0 * time_step_s * time_step_s)
        })
        .collect();
    rate[0] = 0.0;
    second[0] = 0.0;
    Smooth { value, rate, second }
}

/// Zero-phase low pass, 3 dB down at the cutoff; ends are free. Measured and simulated loads both pass it before they
/// are compared.
pub fn zero_phase(values: &[f64], time_step_s: f64, cutoff_hz: f64) -> Vec<f64> {
    whittaker(values, penalty(time_step_s, cutoff_hz), false)
}

/// lambda with `1 / (1 + lambda (2 - 2 cos w)³) = 1/sqrt(2)` at the cutoff; none needed above the Nyquist frequency.
fn penalty(time_step_s: f64, cutoff_hz: f64) -> f64 {
    let w = std::f64::consts::TAU * cutoff_hz * time_step_s;
    if w >= std::f64::consts::PI {
        return 0.0;
    }
    (std::f64::consts::SQRT_2 - 1.0) / (2.0 - 2.0 * w.cos()).powi(3)
}

/// Solves the normal equations by banded Cholesky. `from_rest`: samples before the first one equal the first.
fn whittaker(values: &[f64], lambda: f64, from_rest: bool) -> Vec<f64> {
    let count = values.len();
    // lower band: band[i][d] is the entry (i, i - d)
    let mut band = vec![[1.0, 0.0, 0.0, 0.0]; count];
    let first = if from_rest { 1 } else { BAND };
    for i in first..count {
        let mut row = [(0, 0.0); BAND + 1];
        for (k, coefficient) in THIRD.into_iter().enumerate() {
            row[k] = ((i + k).saturating_sub(BAND), coefficient);
        }
        for (a, x) in row {
            for (b, y) in row {
                if a >= b {
                    // two entries on the first sample meet on the diagonal both ways round: each counts
                    band[a][a - b] += lambda * x * y;
                }
            }
        }
    }
    for i in 0..count {
        for d in (0..=BAND.min(i)).rev() {
            let j = i - d;
            let mut sum = band[i][d];
            for k in i.saturating_sub(BAND).max(j.saturating_sub(BAND))..j {
                sum -= band[i][i - k] * band[j][j - k];
            }
            band[i][d] = if d == 0 { sum.sqrt() } else { sum / band[j][0] };
        }
    }
    let mut solution = values.to_vec();
    for i in 0..count {
        for d in 1..=BAND.min(i) {
            solution[i] -= band[i][d] * solution[i - d];
        }
        solution[i] /= band[i][0];
    }
    for i in (0..count).rev() {
        for d in 1..=BAND.min(count - 1 - i) {
            solution[i] -= band[i + d][d] * solution[i + d];
        }
        solution[i] /= band[i][0];
    }
    solution
}

#[cfg(test)]
mod tests;
