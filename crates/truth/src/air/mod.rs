//! The air: an unsteady vortex lattice of rings on a flat wing with a flat wake that drifts with the stream.
//!
//! All lies in the plane z = 0, so a vortex only ever blows straight through it. The wake's strength is what left the trailing
//! edge when it left; between two times it runs linearly, and a row of the wake has its mean. So what left during the
//! present step counts with half of its newest strength (the trapezoidal rule), and the time step has no lag of first order.

mod harmonic;
mod history;
mod lattice;
mod motions;
mod operator;
mod vortex;
mod wake;

pub use harmonic::Harmonic;
pub(crate) use harmonic::States;
pub use history::Memory;
pub use lattice::{Lattice, Mesh, Strip};
pub use motions::Motions;
pub use operator::{Loads, Operator};
pub use wake::{Part, Rows};
