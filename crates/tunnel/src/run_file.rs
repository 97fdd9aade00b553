//! The part of the tunnel's file that is about runs in time.

use coupling::wing_file::DeflectionTable;
use serde::Deserialize;

/// How runs are measured, and what moves in them that the model does not have.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Dynamics {
    /// Samples per second.
    pub sample_rate_hz: f64,
    /// One standard deviation of the measured angle of attack, degrees.
    pub alpha_sigma_deg: f64,
    /// Every control's actuator.
    pub actuator: ActuatorSettings,
    /// What of a commanded deflection acts, by control surface, airspeed and deflection; left out: all of it.
    #[serde(default)]
    pub deflection: Vec<DeflectionTable>,
    /// What turns with the wing between it and the balance.
    pub joiner: Joiner,
}

/// A second-order actuator.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ActuatorSettings {
    /// Natural frequency.
    pub frequency_hz: f64,
    /// Damping ratio.
    pub damping_ratio: f64,
}

/// A rigid body that pitches with the wing on the balance's metric side.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Joiner {
    /// Mass.
    pub mass_kg: f64,
    /// Centre of gravity aft of the pitch axis.
    pub aft_m: f64,
    /// Pitch inertia about the pitch axis.
    pub inertia_kg_m2: f64,
}

impl Joiner {
    /// What it puts on the balance at a pitch acceleration (rad/s², nose up): Fz, Mx, My. Points aft of the axis go
    /// down as the nose goes up, so their inertia pulls the balance up.
    pub fn loads(&self, alpha_second: f64) -> [f64; 3] {
        [self.mass_kg * self.aft_m * alpha_second, 0.0, -self.inertia_kg_m2 * alpha_second]
    }
}

/// One run.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RunPlan {
    /// CSV file to write.
    pub file: String,
    /// What analyses may use it for.
    pub purpose: Purpose,
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
    pub motion: MotionPlan,
}

/// What analyses may use a run for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
pub enum Purpose {
    /// To find and fit.
    Train,
    /// Only to judge.
    Holdout,
}

/// What moves in a run; angles in degrees.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub enum MotionPlan {
    /// The angle of attack goes to `to_deg` and back once.
    OneMinusCosine {
        /// Largest angle of attack.
        to_deg: f64,
        /// One over the duration.
        frequency_hz: f64,
    },
    /// A control goes trailing edge down, then up, half a period each.
    Doublet {
        /// Which control.
        control: String,
        /// Commanded deflection.
        deflection_deg: f64,
        /// One over the length of both halves.
        frequency_hz: f64,
    },
    /// A control swings with a frequency that rises linearly.
    Chirp {
        /// Which control.
        control: String,
        /// Commanded amplitude.
        deflection_deg: f64,
        /// Frequency at the beginning.
        from_hz: f64,
        /// Frequency at the end.
        to_hz: f64,
        /// Duration.
        duration_s: f64,
    },
}

impl MotionPlan {
    /// The control that moves.
    pub fn control(&self) -> Option<&str> {
        match self {
            Self::OneMinusCosine { .. } => None,
            Self::Doublet { control, .. } | Self::Chirp { control, .. } => Some(control),
        }
    }
}
