//! Noise of balance and sensors: white, buffet of the stream, offsets of blocks and records.

use crate::random::Random;

/// White noise of a sample, N and N m.
const SAMPLE: [f64; 3] = [0.20, 0.12, 0.05];
/// Noise of a static point.
pub(crate) const STATIC_POINT: [f64; 3] = [0.05, 0.03, 0.02];
/// Buffet at 30 m/s.
const BUFFET: [f64; 3] = [0.25, 0.18, 0.06];
/// Length of the gusts that make it, m.
const GUST_M: f64 = 1.2;
/// Offsets of a block and of a record.
pub(crate) const BLOCK: [f64; 3] = [0.08, 0.05, 0.03];
pub(crate) const RECORD: [f64; 3] = [0.04, 0.025, 0.015];
/// Noise of the angle, degrees, and of the tip's height, m.
pub(crate) const ALPHA_DEG: f64 = 0.005;
pub(crate) const TIP_M: f64 = 0.0005;

/// One value a channel.
pub(crate) fn channels(random: &mut Random, sigma: [f64; 3]) -> [f64; 3] {
    sigma.map(|sigma| random.normal(sigma))
}

/// White noise and buffet of a record by channel. A gust lifts the whole wing (shared by all channels) and, half as strongly,
/// its outer part; both pass as the stream takes them, as lags of first order of white noise.
pub(crate) fn of_record(random: &mut Random, v_m_s: f64, samples: usize, rate_hz: f64) -> [Vec<f64>; 3] {
    let keep = (-v_m_s.max(1.0) / (GUST_M * rate_hz)).exp();
    let fresh = (1.0 - keep * keep).sqrt();
    let size = (v_m_s / 30.0).powi(2);
    let (mut whole, mut outer) = (random.normal(1.0), random.normal(1.0));
    let mut all: [Vec<f64>; 3] = std::array::from_fn(|_| Vec::with_capacity(samples));
    for _ in 0..samples {
        let gust = [whole, 0.8 * whole + 0.6 * outer, -0.7 * whole - 0.4 * outer];
        let white = channels(random, SAMPLE);
        for channel in 0..3 {
            all[channel].push(size * BUFFET[channel] * gust[channel] + white[channel]);
        }
        whole = keep * whole + random.normal(fresh);
        outer = keep * outer + random.normal(fresh);
    }
    all
}
