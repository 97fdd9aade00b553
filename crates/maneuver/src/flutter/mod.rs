//! Flutter and divergence: p-k roots of given masses, stiffnesses and air forces, and eigenvalues of a linear system over airspeed.

mod curves;
mod error;
mod forces;
mod pk;
mod root;
mod spline;
mod system;

pub use curves::{Crossing, FlutterCurves, Root};
pub use error::FlutterError;
pub use forces::{FormulaForces, GafTable, GeneralisedForces};
pub use spline::MatrixSpline;
pub use system::Aeroelastic;
