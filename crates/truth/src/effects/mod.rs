//! Effects that are hidden, in forms of this crate's own. Names, units and the order of parameters are those of the
//! benchmark's list; a size of zero changes nothing.
//!
//! They act where they act in the tunnel: on structure and air (`setting`), between command and servo and between servo
//! and air (`control`), on what reaches the balance (`balance`, `bent`), in what is recorded (`sensor`).

mod balance;
mod bent;
mod control;
mod sensor;
mod setting;

pub use setting::V_REF_M_S;

use crate::rig::Flight;

/// An effect with the values of its parameters.
#[derive(Debug, Clone, PartialEq)]
pub struct Effect {
    /// Name.
    pub name: String,
    /// Values, in the order of the benchmark's list.
    pub values: Vec<f64>,
}

/// What an effect may know of a record.
#[derive(Debug, Clone, Copy)]
pub struct Record<'a> {
    /// Airspeed that the campaign says, m/s.
    pub v_m_s: f64,
    /// Dynamic pressure of it, Pa.
    pub q_pa: f64,
    /// Clock time of its beginning, s.
    pub start_s: f64,
    /// Time step, s.
    pub time_step_s: f64,
    /// A number of its own, for random phases; none for a static point.
    pub number: Option<u64>,
    /// Angle of attack, its rate and second derivative.
    pub alpha: &'a [Vec<f64>; 3],
}

impl Effect {
    fn value(&self, place: usize) -> f64 {
        self.values.get(place).copied().unwrap_or_default()
    }

    /// A parameter that chooses one of three.
    fn choice(&self, place: usize) -> usize {
        match self.value(place) {
            low if low < 0.5 => 0,
            middle if middle < 1.5 => 1,
            _ => 2,
        }
    }

    /// Whether loads of strips are needed.
    pub(crate) fn needs_strips(&self) -> bool {
        matches!(self.name.as_str(), "inplane_force" | "large_deflection") && self.value(0) != 0.0
    }
}

/// What balance and data acquisition make of a flight in one record.
pub(crate) fn measured(
    effects: &[Effect],
    record: &Record<'_>,
    strips: &[crate::air::Strip],
    flight: &mut Flight,
) {
    for effect in effects {
        effect.on_balance(record, flight);
        effect.on_bent_wing(record, strips, flight);
    }
    for effect in effects {
        effect.on_record(record, &mut flight.loads);
    }
}
