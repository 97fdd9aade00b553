//! Random numbers that a seed fixes on every platform.

use rand_chacha::ChaCha12Rng;
use rand_chacha::rand_core::{RngCore, SeedableRng};
use rand_distr::{Distribution, StandardNormal};

/// What a stream of numbers is for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Purpose {
    /// A true wing.
    Wing,
    /// What a case draws beside the wing.
    Case,
    /// Offsets of blocks.
    Blocks,
    /// Order of runs.
    Order,
    /// Static points.
    Statics,
    /// Static points of the reference.
    Reference,
    /// A record.
    Record(u64),
    /// The phase of a tone.
    Tone,
    /// Lift of a kind of wing.
    Lift(u64),
}

/// One stream.
#[derive(Debug)]
pub(crate) struct Random(ChaCha12Rng);

impl Random {
    pub(crate) fn new(seed: u64, purpose: Purpose) -> Self {
        let mut generator = ChaCha12Rng::seed_from_u64(seed ^ 0x7275_7468_7669_6e67);
        generator.set_stream(match purpose {
            Purpose::Wing => 11,
            Purpose::Case => 12,
            Purpose::Blocks => 13,
            Purpose::Order => 14,
            Purpose::Statics => 15,
            Purpose::Reference => 16,
            Purpose::Tone => 17,
            Purpose::Lift(kind) => 32 + kind,
            Purpose::Record(number) => 4096 + number,
        });
        Self(generator)
    }

    /// A normal number with mean zero.
    pub(crate) fn normal(&mut self, sigma: f64) -> f64 {
        let unit: f64 = StandardNormal.sample(&mut self.0);
        sigma * unit
    }

    /// A normal number within two and a half standard deviations.
    pub(crate) fn bounded(&mut self, sigma: f64) -> f64 {
        self.normal(1.0).clamp(-2.5, 2.5) * sigma
    }

    /// Between zero and one, one excluded.
    pub(crate) fn unit(&mut self) -> f64 {
        (self.0.next_u64() >> 11) as f64 / 9_007_199_254_740_992.0
    }

    /// A random order of the numbers below `count`.
    pub(crate) fn order(&mut self, count: usize) -> Vec<usize> {
        let mut keyed: Vec<(u64, usize)> = (0..count).map(|i| (self.0.next_u64(), i)).collect();
        keyed.sort_unstable();
        keyed.into_iter().map(|(_, i)| i).collect()
    }
}
