//! The doublet lattice: what oscillation adds to the vortex lattice (Albano and Rodden, AIAA Journal 7, 1969).
//!
//! A(omega) = A of the vortex lattice + [D(omega) - D(0)], with doublets on the quarter lines of the boxes and the same
//! points that receive. So the steady limit is the vortex lattice itself, as in Nastran. Time goes as exp(+i omega t).
//! Frequencies are given as omega/V in 1/m; the reduced frequency is k = (omega/V) `c_ref`/2.

mod exponentials;
mod halves;
mod increment;
mod kept;
pub mod kernel;
mod ladder;
mod numerators;
mod oscillatory;
mod span_fit;
mod strips;

pub use exponentials::KernelIntegral;
pub use oscillatory::{DlmSettings, DoubletLattice, OscillatoryAero, oscillatory};
pub use span_fit::{PLANAR, SpanFit};
