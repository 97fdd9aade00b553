//! What was measured, what is fitted to it, and how.

use crate::flexibility::SingularStructure;
use crate::modes::ModesError;
use nastran::InputError;

/// What a factor multiplies.
#[derive(
    Debug,
    Clone,
    Copy,
    PartialEq,
    Eq,
    PartialOrd,
    Ord,
    serde::Serialize,
    serde::Deserialize,
    schemars::JsonSchema,
)]
pub enum Quantity {
    /// The stiffness of the region's elements.
    Stiffness,
    /// Their mass.
    Mass,
}

/// One unknown: the factor of a region's stiffness or mass.
#[derive(Debug, Clone, PartialEq)]
pub struct Parameter {
    /// The region's name.
    pub region: String,
    /// What is multiplied.
    pub quantity: Quantity,
    /// The region's elements: places in [`crate::Model::elements`].
    pub elements: Vec<usize>,
}

/// A value at one motion: a load (N), a displacement (m), or an entry of a mode shape; degree of freedom of the g-set.
pub type AtMotion = (usize, f64);

/// A measured natural mode.
#[derive(Debug, Clone, PartialEq)]
pub struct MeasuredMode {
    /// Its name.
    pub name: String,
    /// Frequency, Hz.
    pub frequency_hz: f64,
    /// One standard deviation of it.
    pub sigma_hz: f64,
    /// The shape where it was measured, in any scale; empty if it was not.
    pub shape: Vec<AtMotion>,
    /// The number of the model's mode (from 0), where there is no shape to tell.
    pub mode: Option<usize>,
}

/// A measured deflection under loads.
#[derive(Debug, Clone, PartialEq)]
pub struct MeasuredDeflection {
    /// Its name.
    pub name: String,
    /// The loads, N or Nm.
    pub loads: Vec<AtMotion>,
    /// The motion that was measured, degree of freedom of the g-set.
    pub motion: usize,
    /// Its value, m or rad.
    pub value: f64,
    /// One standard deviation of it.
    pub sigma: f64,
}

/// All that was measured.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Measurements {
    /// Natural modes.
    pub modes: Vec<MeasuredMode>,
    /// Deflections.
    pub deflections: Vec<MeasuredDeflection>,
    /// Total mass and its standard deviation, kg.
    pub mass_kg: Option<(f64, f64)>,
}

/// How the fit works.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Settings {
    /// A direction of the factors whose standard deviation is larger is not determined (0.5: not within 50 %).
    pub undetermined: f64,
    /// Modes whose shapes agree less are not paired ([`super::modal_assurance`]).
    pub least_assurance: f64,
    /// Steps at most.
    pub iterations: usize,
}

impl Default for Settings {
    fn default() -> Self {
        Self { undetermined: 0.5, least_assurance: 0.6, iterations: 40 }
    }
}

/// Why no factors could be found.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum UpdateError {
    /// The structure with these factors cannot be assembled.
    #[error("{0}")]
    Input(#[from] InputError),
    /// Its modes could not be computed.
    #[error("{0}")]
    Modes(#[from] ModesError),
    /// It can move without force, so deflections have no meaning.
    #[error("{0}")]
    Singular(#[from] SingularStructure),
}
