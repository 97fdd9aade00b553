//! What calibration leaves open: six directions of corrections at every airspeed, as terms of the simulation.
//!
//! Static root loads determine an offset and a slope of three channels, no more. A factor on all zones, one growing to the
//! tip and a shift of the aerodynamic centre move the slopes; incidence, its gradient along the span and a zero-lift moment
//! move the offsets.

use crate::rules::SharedRules;
use maneuver::effects::{Effect, Inputs, Parameter, Place, Side, Spec};
use maneuver::rom::{Change, Constants};

/// Their names, with units.
const NAMES: &[&str] = &["force", "force_tip", "aft_over_c", "incidence_rad", "gradient_rad_m", "cm0"];
/// Directions of an airspeed.
pub const DIRECTIONS: usize = NAMES.len();

/// All six directions at one airspeed.
#[derive(Debug)]
pub struct Directions {
    /// The airspeed, m/s.
    v_m_s: f64,
    /// Standard deviations before any data.
    wide: [f64; DIRECTIONS],
}

impl Directions {
    /// Of an airspeed, m/s; zero: still air, where they do nothing.
    pub fn new(v_m_s: f64, rules: &SharedRules) -> Self {
        Self { v_m_s, wide: rules.directions }
    }

    fn here(&self, place: &Place<'_>) -> bool {
        self.v_m_s > 0.0 && place.flow.v_m_s == self.v_m_s
    }
}

impl Effect for Directions {
    fn spec(&self) -> &'static Spec {
        &Spec {
            name: "corrections",
            title: "the corrections' six determined directions",
            side: Side::Aerodynamics,
            rivals: &[],
            experiment: "",
        }
    }

    fn parameters(&self) -> Vec<Parameter> {
        (0..DIRECTIONS).map(|k| Parameter::new(NAMES[k], -10.0..=10.0, self.wide[k])).collect()
    }

    fn inputs(&self, p: &[f64], place: &Place<'_>, inputs: &mut Inputs) {
        if self.here(place) && p[3] != 0.0 {
            inputs.incidence_rad.iter_mut().for_each(|value| *value += p[3]);
        }
    }

    fn change(&self, p: &[f64], place: &Place<'_>, change: &mut Change) {
        if self.here(place) {
            for (zone, y) in place.zones.y_norm.iter().enumerate() {
                change.zone_force[zone] += p[0] - p[1] * y * y;
                change.zone_aft_over_c[zone] += p[2];
            }
        }
    }

    fn constants(&self, p: &[f64], place: &Place<'_>, constants: &mut Constants) {
        if self.here(place) {
            constants.upwash_rad_m += p[4];
            constants.moment_coefficient += p[5];
        }
    }
}
