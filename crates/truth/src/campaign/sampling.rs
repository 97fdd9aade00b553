//! From the time step of a flight to the samples of a record: a raised cosine that cuts at 30 Hz without delay.

/// Half of the kernel's width, s: 3 dB down at 30 Hz.
const REACH_S: f64 = 0.012;

/// Samples of a signal every `1/rate_hz`; it goes on with its first and last value.
pub(crate) fn sampled(values: &[f64], time_step_s: f64, rate_hz: f64, samples: usize) -> Vec<f64> {
    let Some(last) = values.len().checked_sub(1) else { return Vec::new() };
    if last == 0 {
        return vec![values[0]; samples];
    }
    #[expect(clippy::cast_possible_truncation, reason = "inside of a record")]
    let nearest = |t_s: f64| (t_s / time_step_s).round() as i64;
    let at = |sample: usize| {
        let t_s = sample as f64 / rate_hz;
        let (mut sum, mut weights) = (0.0, 0.0);
        for place in nearest(t_s - REACH_S)..=nearest(t_s + REACH_S) {
            let away = (place as f64 * time_step_s - t_s) / REACH_S;
            if away.abs() < 1.0 {
                let weight = 1.0 + (std::f64::consts::PI * away).cos();
                let inside = usize::try_from(place).unwrap_or(0).min(last);
                sum += weight * values[inside];
                weights += weight;
            }
        }
        sum / weights
    };
    (0..samples).map(at).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

    #[test]
    fn slow_waves_pass_in_phase_and_thirty_hertz_lose_three_decibels() {
        let dt = 0.00073;
        let height = |hz: f64| {
            let wave: Vec<f64> = (0..4000).map(|i| (TAU * hz * f64::from(i) * dt).cos()).collect();
            // one second is a whole number of periods
            sampled(&wave, dt, 100.0, 200)[100]
        };
        assert!((height(2.0) - 1.0).abs() < 3e-3);
        assert!((height(30.0) - 0.5_f64.sqrt()).abs() < 0.02, "{}", height(30.0));
    }
}
