//! Random numbers that a seed fixes on every platform: ChaCha8, one stream for each purpose.

use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{RngCore, SeedableRng};
use rand_distr::{Distribution, StandardNormal};

/// What a stream is for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Stream {
    /// What is hidden in a case.
    Plan,
    /// The parameters of the true wing.
    Jitter,
    /// The order of the runs.
    Order,
    /// Offsets of blocks and records.
    Offsets,
    /// Static points.
    Statics,
    /// Static points of the reference campaign.
    Reference,
    /// A record of a run.
    Record(u64),
}

/// One stream.
#[derive(Debug)]
pub(crate) struct Random(ChaCha8Rng);

impl Random {
    /// The stream of a case for a purpose.
    pub(crate) fn new(seed: u64, stream: Stream) -> Self {
        let mut generator = ChaCha8Rng::seed_from_u64(seed);
        generator.set_stream(match stream {
            Stream::Plan => 1,
            Stream::Jitter => 2,
            Stream::Order => 3,
            Stream::Offsets => 4,
            Stream::Statics => 5,
            Stream::Reference => 6,
            Stream::Record(number) => 1000 + number,
        });
        Self(generator)
    }

    /// A normal number with mean zero.
    pub(crate) fn normal(&mut self, sigma: f64) -> f64 {
        let unit: f64 = StandardNormal.sample(&mut self.0);
        sigma * unit
    }

    /// A number between zero and one, one excluded.
    pub(crate) fn unit(&mut self) -> f64 {
        // 53 bits of the generator
        (self.0.next_u64() >> 11) as f64 / 9_007_199_254_740_992.0
    }

    /// A number with a logarithm that is uniform between those of two positive ends.
    pub(crate) fn log_uniform(&mut self, low: f64, high: f64) -> f64 {
        low * (high / low).powf(self.unit())
    }

    /// One of `count` numbers from zero.
    pub(crate) fn below(&mut self, count: usize) -> usize {
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "below count")]
        let drawn = (self.unit() * count as f64) as usize;
        drawn.min(count.saturating_sub(1))
    }

    /// A random order of the numbers below `count`.
    pub(crate) fn order(&mut self, count: usize) -> Vec<usize> {
        let mut order: Vec<usize> = (0..count).collect();
        for i in (1..count).rev() {
            order.swap(i, self.below(i + 1));
        }
        order
    }
}
