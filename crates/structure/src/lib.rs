#![doc = include_str!("../README.md")]

mod assemble;
mod autospc;
pub mod beam;
mod beam_load;
mod beam_mass;
mod blocks;
mod cell_shape;
mod condensation;
mod constraints;
mod corotation;
mod damper;
mod dofs;
pub mod effective_mass;
pub mod element;
mod factor;
pub mod flexibility;
mod jacobi;
pub mod laminate;
mod lanczos;
pub mod mass_properties;
pub mod masses;
pub mod matrix_element;
pub mod mesh;
pub mod model;
pub mod modes;
pub mod nonlinear;
mod ordering;
pub mod plane_material;
mod section;
mod serendipity;
mod shear_panel;
pub mod shell;
pub mod solid;
pub mod solid_material;
mod sparse;
mod springs;
pub mod sturm;
mod subspace;
pub mod system;
pub mod unsymmetric;
pub mod update;

pub use beam::{Beam, BeamPlacement};
pub use condensation::{Reduced, reduced};
pub use constraints::Dependent;
pub use constraints::joint::{Joint, Tie};
pub use corotation::Corotation;
pub use damper::{Damper, modal_damping};
pub use effective_mass::{effective_masses, masses_along};
pub use element::Element;
pub use flexibility::{Flexibility, SingularStructure};
pub use laminate::{PlacedPly, ShearModel, ShellSection};
pub use mass_properties::MassProperties;
pub use masses::PointMass;
pub use matrix_element::MatrixElement;
pub use mesh::{CellShape, MeshCell};
pub use model::{
    Clamp, MassForm, Model, Node, dampers, enforced_motions, load_sets, loads_of, modal_structural_damping,
    thermal_loads,
};
pub use modes::{Modes, ModesError, normal_modes, normal_modes_below};
pub use plane_material::PlaneMaterial;
pub use shell::{CurvedPlace, CurvedShell, SectionAxis, Shell, ShellStrains};
pub use solid::{QuadraticSolid, Solid};
pub use solid_material::SolidMaterial;
pub use sturm::count_below;
pub use system::System;
