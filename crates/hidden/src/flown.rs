//! A run as it is simulated: what moved, and what the balance would show, at the simulation's time step.

use crate::strips::ZONES;

/// What an effect may know of a run.
#[derive(Debug, Clone, Copy)]
pub struct At<'a> {
    /// Airspeed that the campaign says, m/s.
    pub v_m_s: f64,
    /// Dynamic pressure of it, Pa.
    pub q_pa: f64,
    /// Clock time of the run's beginning, s.
    pub start_s: f64,
    /// Time step, s.
    pub time_step_s: f64,
    /// Number of the record in the campaign: random phases follow from it.
    pub record: u64,
    /// Angle of attack, rad.
    pub alpha_rad: &'a [f64],
    /// Its rate, rad/s.
    pub alpha_rate: &'a [f64],
    /// Its second derivative, rad/s².
    pub alpha_second: &'a [f64],
}

/// Loads and displacements of the zones, each by zone and sample.
#[derive(Debug, Clone, PartialEq)]
pub struct Zones {
    /// Lift, N.
    pub lift_n: Vec<Vec<f64>>,
    /// Height of the quarter points, m.
    pub height_m: Vec<Vec<f64>>,
    /// Nose-up twist, rad.
    pub twist_rad: Vec<Vec<f64>>,
    /// Area, m².
    pub area_m2: [f64; ZONES],
    /// Middle along the span, m.
    pub y_m: [f64; ZONES],
}

/// See the module.
#[derive(Debug, Clone, PartialEq)]
pub struct Flown {
    /// Fz, Mx, My by sample.
    pub loads: [Vec<f64>; 3],
    /// Height of the tip, m.
    pub tip_z_m: Vec<f64>,
    /// Zones, if an effect needs them.
    pub zones: Option<Zones>,
}
