//! The wing at an airspeed, in steps of the simulation.

use crate::design::{SAMPLE_RATE_HZ, STEPS_PER_SAMPLE};
use crate::system::LinearWing;
use maneuver::ExactStep;

/// Time step of the simulation, s.
pub(crate) const STEP_S: f64 = 1.0 / (SAMPLE_RATE_HZ * STEPS_PER_SAMPLE) as f64;

/// The wing at an airspeed, ready to fly.
#[derive(Debug)]
pub(crate) struct AtSpeed {
    pub(crate) v_m_s: f64,
    pub(crate) linear: LinearWing,
    pub(crate) step: ExactStep,
}
