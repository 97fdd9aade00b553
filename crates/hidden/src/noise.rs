//! What the balance adds: white noise, buffet that grows with dynamic pressure, offsets of blocks and of records.

use crate::design::{RHO_KG_M3, SAMPLE_RATE_HZ};
use crate::random::Random;

/// White noise of one sample: N, N m, N m.
pub(crate) const SAMPLE: [f64; 3] = [0.20, 0.12, 0.05];
/// Noise of one static point, an average.
pub(crate) const STATIC_POINT: [f64; 3] = [0.05, 0.03, 0.02];
/// Buffet at 30 m/s.
const BUFFET: [f64; 3] = [0.25, 0.18, 0.06];
/// Its correlation time, s.
const BUFFET_S: f64 = 0.05;
/// Offsets of a block and of a record.
pub(crate) const BLOCK: [f64; 3] = [0.08, 0.05, 0.03];
pub(crate) const RECORD: [f64; 3] = [0.04, 0.025, 0.015];
/// Noise of the measured angle, degrees, and of the tip's height, m.
pub(crate) const ALPHA_DEG: f64 = 0.005;
pub(crate) const TIP_M: f64 = 0.0005;

/// Standard deviation of a channel's buffet at a dynamic pressure.
pub(crate) fn buffet_sigma(channel: usize, q_pa: f64) -> f64 {
    BUFFET[channel] * q_pa / (0.5 * RHO_KG_M3 * 900.0)
}

/// How many samples of buffet say as much as one of white noise of the same size, about a slow difference: (1 + r)/(1 - r).
pub(crate) fn correlated_samples() -> f64 {
    let keep = keep();
    (1.0 + keep) / (1.0 - keep)
}

/// Correlation of neighbouring samples.
fn keep() -> f64 {
    (-1.0 / (SAMPLE_RATE_HZ as f64 * BUFFET_S)).exp()
}

/// Normal numbers with correlations 0.8 (Fz, Mx), -0.7 (Fz, My) and -0.6 (Mx, My): rows of their matrix's factor.
fn correlated(random: &mut Random) -> [f64; 3] {
    let n: [f64; 3] = std::array::from_fn(|_| random.normal(1.0));
    let second = (1.0_f64 - 0.64).sqrt();
    let across = (-0.6 + 0.8 * 0.7) / second;
    let rest = (1.0 - 0.49 - across * across).sqrt();
    [n[0], 0.8 * n[0] + second * n[1], -0.7 * n[0] + across * n[1] + rest * n[2]]
}

/// One value a channel.
pub(crate) fn channels(random: &mut Random, sigma: [f64; 3]) -> [f64; 3] {
    sigma.map(|sigma| random.normal(sigma))
}

/// White noise and buffet of a record, by channel and sample.
pub(crate) fn of_record(random: &mut Random, q_pa: f64, samples: usize) -> [Vec<f64>; 3] {
    let keep = keep();
    let fresh = (1.0 - keep * keep).sqrt();
    let mut buffet = correlated(random);
    let mut all: [Vec<f64>; 3] = std::array::from_fn(|_| Vec::with_capacity(samples));
    for _ in 0..samples {
        let white = channels(random, SAMPLE);
        for channel in 0..3 {
            all[channel].push(buffet_sigma(channel, q_pa) * buffet[channel] + white[channel]);
        }
        let shock = correlated(random);
        buffet = std::array::from_fn(|channel| keep * buffet[channel] + fresh * shock[channel]);
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::Stream;

    #[test]
    fn buffet_has_the_stated_size_and_correlation() {
        let mut random = Random::new(7, Stream::Record(0));
        let q_pa = 4.0 * 0.5 * RHO_KG_M3 * 900.0;
        let noise = of_record(&mut random, q_pa, 200_000);
        let product = |a: usize, b: usize| {
            noise[a].iter().zip(&noise[b]).map(|(x, y)| x * y).sum::<f64>() / noise[a].len() as f64
        };
        // variance: buffet four times as large as at 30 m/s, and the white part
        let fz = 1.0_f64 + 0.04;
        assert!((product(0, 0) / fz - 1.0).abs() < 0.03, "{}", product(0, 0));
        let mx = 0.72_f64;
        assert!((product(0, 1) / (0.8 * mx) - 1.0).abs() < 0.05, "{}", product(0, 1));
    }
}
