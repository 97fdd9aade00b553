//! `result.json` of `modes`, without and with measurements.

use std::collections::BTreeMap;

use schemars::JsonSchema;
use serde::Serialize;

/// Natural modes of a structure.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct ModesResult {
    /// Name of the command.
    pub(crate) command: &'static str,
    /// Name of the structure.
    pub(crate) structure: String,
    /// Mass.
    pub(crate) mass_kg: f64,
    /// Centre of gravity: x, y, z.
    pub(crate) centre_of_gravity_m: [f64; 3],
    /// Tensor of inertia about the centre of gravity, kg m2, row by row.
    pub(crate) inertia_about_centre_kg_m2: [[f64; 3]; 3],
    /// Number of grids.
    pub(crate) grids: usize,
    /// Number of motions that are not held.
    pub(crate) free_motions: usize,
    /// Number of elements by card.
    pub(crate) elements: BTreeMap<&'static str, usize>,
    /// Natural frequencies, ascending.
    pub(crate) frequencies_hz: Vec<f64>,
    /// How many of them are rigid motions.
    pub(crate) rigid_modes: usize,
    /// By mode: effective masses along x, y, z (kg) and effective inertias about them (kg m2).
    pub(crate) effective_masses: Vec<[f64; 6]>,
    /// Wall clock.
    pub(crate) seconds: f64,
}

/// A structure fitted to measurements.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct ModesMeasuredResult {
    /// Name of the command.
    pub(crate) command: &'static str,
    /// Name of the structure.
    pub(crate) structure: String,
    /// Mass.
    pub(crate) mass_kg: f64,
    /// Number of grids.
    pub(crate) grids: usize,
    /// Number of elements by card.
    pub(crate) elements: BTreeMap<&'static str, usize>,
    /// Natural frequencies of the structure as given.
    pub(crate) frequencies_hz: Vec<f64>,
    /// Measurements beside both models.
    pub(crate) measurements: Vec<MeasurementResult>,
    /// Factors of regions.
    pub(crate) factors: Vec<RegionFactor>,
    /// Covariance of the factors; null where the data do not determine them.
    #[schemars(with = "Vec<Vec<Option<f64>>>")]
    pub(crate) covariance: Vec<Vec<f64>>,
    /// Directions that the measurements leave open: factors with their parts.
    pub(crate) undetermined: Vec<Vec<(String, f64)>>,
    /// How many directions of the factors the measurements determine; null if their noise is not known.
    #[schemars(with = "Option<usize>")]
    pub(crate) determined_directions: usize,
    /// Modes of the structure as given.
    pub(crate) before: StateResult,
    /// Modes of the fitted structure.
    pub(crate) after: StateResult,
    /// Measurements less determined directions.
    pub(crate) degrees_of_freedom: usize,
    /// Steps of the fit.
    pub(crate) steps: usize,
    /// Whether the fit reached its minimum.
    pub(crate) converged: bool,
    /// Wall clock.
    pub(crate) seconds: f64,
}

/// A measurement beside both models.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct MeasurementResult {
    /// Its name.
    pub(crate) name: String,
    /// Its unit.
    pub(crate) unit: String,
    /// Measured.
    pub(crate) measured: f64,
    /// One standard deviation of it.
    pub(crate) sigma: f64,
    /// Of the structure as given; null if no mode is paired with it.
    pub(crate) before: Option<f64>,
    /// Of the fitted structure; null if no mode is paired with it.
    pub(crate) after: Option<f64>,
}

/// The factor of a region.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct RegionFactor {
    /// The region.
    pub(crate) region: String,
    /// `stiffness` or `mass`.
    pub(crate) quantity: &'static str,
    /// The factor.
    pub(crate) value: f64,
    /// Its standard deviation; null if the data do not determine it.
    pub(crate) sigma: Option<f64>,
    /// Whether the data determine it.
    pub(crate) determined: bool,
}

/// The modes of a structure beside the measured ones.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct StateResult {
    /// Natural frequencies.
    pub(crate) frequencies_hz: Vec<f64>,
    /// Modal assurance of each measured mode with each of the structure; empty for one without a measured shape.
    pub(crate) modal_assurance: Vec<Vec<f64>>,
    /// The structure's mode for each measured one, from 1; null for none.
    pub(crate) pairs: Vec<Option<usize>>,
    /// Sum of the squared residuals in standard deviations.
    pub(crate) chi_square: f64,
    /// How many measurements are behind it.
    pub(crate) compared: usize,
}
