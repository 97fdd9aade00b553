#![doc = include_str!("../README.md")]

mod assemble;
pub mod beam;
mod beam_mass;
mod dofs;
pub mod effective_mass;
pub mod element;
pub mod flexibility;
pub mod mass_properties;
pub mod masses;
pub mod mesh;
pub mod model;
pub mod modes;
mod rigid;
mod section;
mod sparse;
pub mod sturm;
mod subspace;
pub mod system;

pub use beam::{Beam, BeamPlacement};
pub use effective_mass::effective_masses;
pub use element::Element;
pub use flexibility::{Flexibility, SingularStructure};
pub use mass_properties::MassProperties;
pub use masses::PointMass;
pub use mesh::{CellShape, MeshCell};
pub use model::{Clamp, Model, Node};
pub use modes::{Modes, ModesError, normal_modes};
pub use rigid::RigidLink;
pub use sturm::count_below;
pub use system::System;
