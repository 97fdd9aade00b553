//! A maneuver declared in RON: airspeed, angle of attack, sampling, and what moves. Reading it refuses what cannot be
//! by line and column; [`ManeuverFile::checked`] refuses what the wing cannot do.

mod check;
mod sampled;

pub use check::DEFAULT_LIMIT_DEG;

use crate::motion::MotionSpec;
use crate::rig::{Actuator, RigSettings};
use nastran::{InputError, ron_file};
use schemars::JsonSchema;
use serde::Deserialize;
use std::path::{Path, PathBuf};

/// A maneuver as its file declares it; angles in degrees.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, rename = "Maneuver")]
pub struct ManeuverFile {
    /// Airspeed; zero is wind-off.
    #[serde(rename = "V_m_s")]
    pub v_m_s: f64,
    /// Air density; left out: 1.225 kg/m³, sea level.
    #[serde(default = "sea_level")]
    pub rho_kg_m3: f64,
    /// Angle of attack at the beginning; left out only if an own signal gives the angle.
    #[serde(default)]
    pub alpha_deg: Option<f64>,
    /// Samples per second.
    pub sample_rate_hz: f64,
    /// From the first sample to the last.
    pub length_s: f64,
    /// What moves the control surfaces.
    #[serde(default)]
    pub actuator: ActuatorChoice,
    /// What moves; motions of the same thing add up.
    pub motions: Vec<MotionSpec>,
    /// The file as it was named when read.
    #[serde(skip)]
    pub path: PathBuf,
}

/// What stands between a commanded deflection and the control surface.
#[derive(Debug, Clone, Copy, PartialEq, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub enum ActuatorChoice {
    /// The servos of the wing's file.
    #[default]
    Assumed,
    /// Nothing: surfaces follow at once, so no command may jump. It is flown as an actuator of ten times the sampling
    /// rate, late by a fiftieth of a sample.
    None,
    /// A second-order actuator.
    SecondOrder {
        /// Natural frequency.
        frequency_hz: f64,
        /// Damping ratio.
        damping_ratio: f64,
    },
}

fn sea_level() -> f64 {
    1.225
}

impl ManeuverFile {
    /// Reads a maneuver and the signals it names.
    ///
    /// # Errors
    /// A missing or misspelt field, a negative time or length, a frequency above half the sampling rate, an airspeed or
    /// angle that cannot be, a file that is missing: with file, line and column.
    pub fn read(path: &Path) -> Result<Self, InputError> {
        let mut file: Self = ron_file::read(path)?;
        file.path = path.to_path_buf();
        check::numbers(&file)?;
        let base = file.alpha_deg.unwrap_or(0.0).to_radians();
        for spec in &mut file.motions {
            spec.complete(base, path)?;
        }
        check::angle_is_given_once(&file)?;
        Ok(file)
    }

    /// Name of the file without folder and ending, which results take.
    pub fn name(&self) -> String {
        self.path.file_stem().map_or_else(String::new, |stem| stem.to_string_lossy().into_owned())
    }

    /// The rig's settings with the maneuver's actuator.
    pub fn settings(&self, base: &RigSettings) -> RigSettings {
        let actuator = match self.actuator {
            ActuatorChoice::Assumed => base.actuator,
            ActuatorChoice::None => {
                Actuator { frequency_hz: 10.0 * self.sample_rate_hz, damping_ratio: 0.5_f64.sqrt() }
            }
            ActuatorChoice::SecondOrder { frequency_hz, damping_ratio } => {
                Actuator { frequency_hz, damping_ratio }
            }
        };
        RigSettings { actuator, ..base.clone() }
    }

    /// Number of samples.
    pub fn samples(&self) -> usize {
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "reading bounds the number of samples"
        )]
        let steps = (self.length_s * self.sample_rate_hz).round() as usize;
        steps + 1
    }

    /// Times of the samples, s.
    pub fn times(&self) -> Vec<f64> {
        (0..self.samples()).map(|i| i as f64 / self.sample_rate_hz).collect()
    }
}
