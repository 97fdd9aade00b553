//! The wing that really bends in steady air: boxes carried by the structure in three dimensions, the lattice rebuilt where they
//! are, and the equilibrium of both.
//!
//! ```text
//! f_inner(u) = f_weight + f_air(u; alpha, controls, corrections)
//! ```
//! Each box moves rigidly with the point of the axis that its spline ties it to. Its incidence is the stream along its normal
//! (a sine, no angle), its force stands on the stream and on its bound vortex (Kutta and Joukowski): a bent wing
//! whose forces stood on the boxes instead would turn leading-edge suction that is not there into torsion. The drag that
//! the wake induces is not in the forces. Factors and offsets of corrections stay with their boxes. Small
//! deflections are the limit: [`crate::ElasticWing`], term by term.

mod adjoint;
mod air;
mod answer;
mod boxes;
mod free;
mod model;
mod motion;
#[cfg(test)]
mod samples;
mod wake;
mod wing;

pub use boxes::CarriedPart;
pub use free::{FreeBody, FreeState, SteadyFlight};
pub use model::LargeModel;
pub use motion::{BentMotion, BentMotionError};
pub use wake::Wake;
pub use wing::{LargeState, LargeWing};

#[cfg(test)]
mod tests;
