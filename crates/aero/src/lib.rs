#![doc = include_str!("../README.md")]

pub mod airfoil;
pub mod controls;
pub mod corrections;
pub mod dlm;
pub mod error;
pub mod flow;
pub mod geometry;
pub mod horseshoe;
pub mod incidence;
pub mod integration;
mod lanes;
pub mod lattice;
pub mod load_operator;
pub mod mirror;
pub mod moved;
pub mod seams;
pub mod stream_axes;
mod strip_vortices;
pub mod vlm;

pub use airfoil::Airfoil;
pub use controls::ControlSurface;
pub use corrections::Corrections;
pub use dlm::{DlmSettings, DoubletLattice, KernelIntegral, OscillatoryAero, SpanFit, oscillatory};
pub use error::AeroError;
pub use flow::Flow;
pub use geometry::AeroBox;
pub use incidence::camber_and_twist;
pub use integration::{BoxLoads, Integration};
pub use lattice::{Lattice, Surface};
pub use load_operator::{LoadDerivatives, LoadOperator};
pub use mirror::{BoxMap, MirrorPlane};
pub use moved::influence_by_motion;
pub use seams::Seams;
pub use stream_axes::StreamAxes;
pub use vlm::{SteadyAero, influence, influence_of_moved};
