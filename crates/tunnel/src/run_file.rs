//! The part of the tunnel's file that is about runs in time.

use calibrate::Use;
use coupling::RootLoads;
use coupling::wing_file::DeflectionTable;
use maneuver::Actuator;
use maneuver::motion::MotionSpec;
use schemars::JsonSchema;
use serde::Deserialize;

/// How runs are measured, and what moves in them that the model does not have.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Dynamics {
    /// Samples per second.
    pub sample_rate_hz: f64,
    /// One standard deviation of the measured angle of attack, degrees.
    pub alpha_sigma_deg: f64,
    /// Every control's actuator; left out: the servos of the wing's file.
    #[serde(default)]
    pub actuator: Option<Actuator>,
    /// What of a commanded deflection acts, by control surface, airspeed and deflection; left out: all of it.
    #[serde(default)]
    pub deflection: Vec<DeflectionTable>,
    /// What turns with the wing between it and the balance.
    pub joiner: Joiner,
}

/// A rigid body that pitches with the wing on the balance's metric side.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Joiner {
    /// Mass.
    pub mass_kg: f64,
    /// Centre of gravity aft of the pitch axis.
    pub aft_m: f64,
    /// Pitch inertia about the pitch axis, kg m².
    pub inertia_kg_m2: f64,
}

impl Joiner {
    /// What it puts on the balance at a pitch acceleration (rad/s², nose up). Points aft of the axis go
    /// down as the nose goes up, so their inertia pulls the balance up.
    pub fn loads(&self, alpha_second: f64) -> RootLoads {
        RootLoads {
            fz_n: self.mass_kg * self.aft_m * alpha_second,
            mx_nm: 0.0,
            my_nm: -self.inertia_kg_m2 * alpha_second,
        }
    }
}

/// One run.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RunPlan {
    /// CSV file to write.
    pub file: String,
    /// What analyses may use it for.
    pub purpose: Use,
    /// Day: its offset, the static cases' of that name, is on all samples of a run in the wind.
    #[serde(default)]
    pub block: Option<String>,
    /// File of the run that this one repeats.
    #[serde(default)]
    pub repeat_of: Option<String>,
    /// Airspeed; zero is wind-off.
    #[serde(rename = "V_m_s")]
    pub v_m_s: f64,
    /// Angle of attack at the beginning, degrees.
    pub alpha_deg: f64,
    /// Length.
    pub length_s: f64,
    /// What moves.
    pub motion: MotionSpec,
}
