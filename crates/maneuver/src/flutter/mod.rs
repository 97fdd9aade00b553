//! Flutter and divergence: p-k roots of given masses, stiffnesses and air forces, and eigenvalues of a linear system over airspeed.

mod bent;
mod bent_sweep;
mod complete;
mod curves;
mod divergence;
mod error;
mod forces;
mod k_method;
mod modal_air;
mod pk;
mod rig_forces;
mod root;
mod scheduled;
mod spline;
mod state_space;
mod sweep;
mod system;

pub use bent::{BentFlutterError, BentPoint};
pub use bent_sweep::{BentCrossing, BentFlutter, BentSweep};
pub use complete::{Branch, CompleteCurves};
pub use curves::{Crossing, FlutterCurves, Root, first_flutter};
pub use divergence::first_divergence;
pub use error::FlutterError;
pub use forces::{FormulaForces, GafTable, GeneralisedForces, SplitForces};
pub use k_method::KRoot;
pub use modal_air::{gaf_table, incidence_of_motion};
pub use rig_forces::ModePressures;
pub use scheduled::ScheduledForces;
pub use spline::MatrixSpline;
pub use state_space::{changes_of_stability, flutter_of_state_space};
pub use system::Aeroelastic;
