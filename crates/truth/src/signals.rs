//! Lags and shifts of sampled signals that rest before their first sample.

/// A lag of first order by the trapezoidal rule.
pub(crate) fn lagged(values: &[f64], lag_s: f64, time_step_s: f64) -> Vec<f64> {
    let a = 2.0 * lag_s / time_step_s;
    let mut before = values.first().map_or((0.0, 0.0), |first| (*first, *first));
    let step = |value: &f64| {
        let now = (value + before.0 + (a - 1.0) * before.1) / (a + 1.0);
        before = (*value, now);
        now
    };
    values.iter().map(step).collect()
}

/// `x'' + 2 z w x' + w² x = w² u` by the average acceleration.
pub(crate) fn second_order(values: &[f64], omega: f64, zeta: f64, time_step_s: f64) -> Vec<f64> {
    let dt = time_step_s;
    let (mut x, mut v, mut a) = (values.first().copied().unwrap_or_default(), 0.0, 0.0);
    let effective = 1.0 + zeta * omega * dt + 0.25 * (omega * dt).powi(2);
    let mut first = true;
    let step = |u: &f64| {
        if std::mem::take(&mut first) {
            return x;
        }
        let (position, velocity) = (x + dt * v + 0.25 * dt * dt * a, v + 0.5 * dt * a);
        a = (omega * omega * (u - position) - 2.0 * zeta * omega * velocity) / effective;
        x = position + 0.25 * dt * dt * a;
        v = velocity + 0.5 * dt * a;
        x
    };
    values.iter().map(step).collect()
}

/// A signal `steps` earlier (later if negative): Lagrange's polynomial through six samples.
pub(crate) fn early(values: &[f64], steps: f64) -> Vec<f64> {
    let Some(last) = values.len().checked_sub(1) else { return Vec::new() };
    (0..values.len()).map(|i| at(values, (i as f64 + steps).clamp(0.0, last as f64))).collect()
}

/// The value at a place between samples.
pub(crate) fn at(values: &[f64], place: f64) -> f64 {
    let last = values.len().saturating_sub(1);
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "inside of the record")]
    let before = (place.max(0.0) as usize).min(last);
    let t = place - before as f64;
    let sample = |k: i32| {
        let place = before.saturating_add_signed(k as isize);
        values[place.min(last)]
    };
    (-2..=3_i32)
        .map(|k| {
            let others = (-2..=3_i32).filter(|j| *j != k);
            let weight: f64 = others.map(|j| (t - f64::from(j)) / f64::from(k - j)).product();
            weight * sample(k)
        })
        .sum()
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

    const DT: f64 = 0.0007;

    fn ramp() -> Vec<f64> {
        (0..3000).map(|i| f64::from(i) * DT).collect()
    }

    #[test]
    fn a_ramp_comes_as_late_as_the_lags_say() {
        assert!((ramp()[2999] - lagged(&ramp(), 0.03, DT)[2999] - 0.03).abs() < 1e-9);
        let servo = second_order(&ramp(), 90.0, 0.8, DT);
        assert!((ramp()[2999] - servo[2999] - 1.6 / 90.0).abs() < 1e-9);
        assert!((early(&ramp(), -12.3)[2000] - (ramp()[2000] - 12.3 * DT)).abs() < 1e-9);
    }

    #[test]
    fn a_wave_is_shifted_without_losing_height() {
        let wave: Vec<f64> = (0..3000).map(|i| (TAU * 10.0 * f64::from(i) * DT).sin()).collect();
        for (i, shifted) in early(&wave, 7.4).iter().enumerate().take(2900).skip(10) {
            assert!((shifted - (TAU * 10.0 * (i as f64 + 7.4) * DT).sin()).abs() < 1e-7);
        }
    }
}
