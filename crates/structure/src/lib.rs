#![doc = include_str!("../README.md")]

mod assemble;
pub mod beam;
mod beam_mass;
mod constraints;
mod dofs;
pub mod element;
pub mod flexibility;
pub mod laminate;
pub mod mass_properties;
pub mod masses;
pub mod matrix_element;
pub mod model;
pub mod modes;
pub mod plane_material;
mod section;
pub mod shell;
mod sparse;
mod springs;
pub mod sturm;
mod subspace;
pub mod system;

pub use beam::{Beam, BeamPlacement};
pub use constraints::Dependent;
pub use element::Element;
pub use flexibility::{Flexibility, SingularStructure};
pub use laminate::{PlacedPly, ShearModel, ShellSection};
pub use mass_properties::MassProperties;
pub use masses::PointMass;
pub use matrix_element::MatrixElement;
pub use model::{Clamp, MassForm, Model, Node};
pub use modes::{Modes, ModesError, normal_modes};
pub use plane_material::PlaneMaterial;
pub use shell::{Shell, ShellStrains};
pub use sturm::count_below;
pub use system::System;
