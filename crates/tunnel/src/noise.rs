//! Random numbers that are the same on every platform: ChaCha8 with one stream for each purpose, so that what is
//! added to a campaign leaves the rest of it as it was.

use crate::file::ChannelNoise;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;
use rand_distr::{Distribution, StandardNormal};

/// What a stream is for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Stream {
    /// Rows of the static cases.
    StaticRows,
    /// Offsets of blocks.
    BlockOffsets,
    /// Tilt tares.
    TiltTares,
    /// The run with this number.
    Run(u32),
}

/// One stream of standard normal numbers.
#[derive(Debug)]
pub(crate) struct NoiseSource(ChaCha8Rng);

impl NoiseSource {
    pub(crate) fn new(seed: u64, stream: Stream) -> Self {
        let mut generator = ChaCha8Rng::seed_from_u64(seed);
        generator.set_stream(match stream {
            Stream::StaticRows => 1,
            Stream::BlockOffsets => 2,
            Stream::TiltTares => 3,
            Stream::Run(number) => 1000 + u64::from(number),
        });
        Self(generator)
    }

    /// A normal number with mean zero.
    pub(crate) fn normal(&mut self, sigma: f64) -> f64 {
        let unit: f64 = StandardNormal.sample(&mut self.0);
        sigma * unit
    }

    /// One normal number a channel.
    pub(crate) fn channels(&mut self, sigma: ChannelNoise) -> [f64; 3] {
        sigma.to_array().map(|sigma| self.normal(sigma))
    }
}
