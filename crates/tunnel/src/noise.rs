//! Random numbers that are the same on every platform: ChaCha8 with one stream for each purpose, so that what is
//! added to a campaign leaves the rest of it as it was.

use coupling::{ByLoad, RootLoads};
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
    /// Weight tares.
    WeightTares,
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
            Stream::WeightTares => 3,
            Stream::Run(number) => 1000 + u64::from(number),
        });
        Self(generator)
    }

    /// A normal number with mean zero.
    pub(crate) fn normal(&mut self, sigma: f64) -> f64 {
        let unit: f64 = StandardNormal.sample(&mut self.0);
        sigma * unit
    }

    /// A normal number for each load.
    pub(crate) fn loads(&mut self, sigma: ByLoad<f64>) -> RootLoads {
        let ByLoad { fz, mx, my } = sigma.map(|sigma| self.normal(sigma));
        RootLoads { fz_n: fz, mx_nm: mx, my_nm: my }
    }
}
