//! The doublet lattice: what oscillation adds to the vortex lattice.

pub mod exponentials;
pub mod kernel;
mod ladder;
mod lanes;
mod numerators;
pub mod span_fit;

pub use exponentials::KernelIntegral;
pub use span_fit::SpanFit;
