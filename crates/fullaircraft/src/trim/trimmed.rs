//! Balanced flight of the elastic aircraft at a given load factor, airspeed and pitch rate.
//!
//! ```text
//! P = q W S Q (D G u + alpha n_z + (x - x_cg) rate/V + camber + elevator) + q S f_e
//! u = F (Gᵀ P - n g M z)          (held at the centre, where alpha is counted)
//! sum Fz = n m g,   sum My about the centre of gravity = 0
//! ```
//! Solved as one of the trims of [`crate::trim::case`]; with wings only, alpha follows from the lift alone. Load factor, airspeed and pitch rate are taken as they are:
//! a steady pull-up has the pitch rate (n - 1) g/V, and [`FlightPoint::warning`] says so if it has not.
//! Small angles: lift is along z, the weight's component along x is left out, loads act on the undeformed places.

use crate::aircraft::file::{FlightPoint, Surfaces};
use crate::error::AircraftError;
use crate::trim::case::{TrimCase, TrimTools};
use crate::trim::model::{FlightModel, Trimmed};
use crate::trim::variables::MOTIONS;
use coupling::GRAVITY_M_S2;

/// Pitch rates that differ by more than this share are warned about.
const PITCH_RATE_TOLERANCE: f64 = 0.02;

impl FlightPoint {
    /// Pitch rate of a steady pull-up or push-down with this load factor: (n - 1) g/V, rad/s.
    pub fn steady_pitch_rate_rad_s(&self) -> f64 {
        (self.load_factor - 1.0) * GRAVITY_M_S2 / self.v_m_s
    }

    /// A sentence if the pitch rate is more than 2 % off (n - 1) g/V.
    pub fn warning(&self, name: &str) -> Option<String> {
        let steady_deg_s = self.steady_pitch_rate_rad_s().to_degrees();
        let off = (self.pitch_rate_deg_s - steady_deg_s).abs();
        (off > PITCH_RATE_TOLERANCE * steady_deg_s.abs()).then(|| {
            format!(
                "{name}: the pitch rate {} deg/s is not that of steady flight, (n - 1) g/V = {steady_deg_s:.2} deg/s; \
                 all three numbers are used as given",
                self.pitch_rate_deg_s
            )
        })
    }
}

impl FlightModel<'_> {
    /// Balanced flight at a point; `name` is what errors call it.
    ///
    /// # Errors
    /// [`AircraftError::NotTrimmable`] if the aircraft diverges at this speed or nothing balances it.
    pub fn trim(&self, name: &str, point: &FlightPoint) -> Result<Trimmed, AircraftError> {
        let refuse = |why: String| AircraftError::NotTrimmable {
            point: name.to_owned(),
            v_m_s: point.v_m_s,
            load_factor: point.load_factor,
            why,
        };
        let tools = TrimTools::new(self.aircraft, &[])?;
        let at = tools.at(self, point.v_m_s).map_err(|error| refuse(error.to_string()))?;
        let balanced = at.solve(&self.symmetric(name, point)).map_err(|error| match error {
            AircraftError::Input(input) => {
                refuse(format!("{}; {}", input.message, input.help.unwrap_or_default()))
            }
            other => other,
        })?;
        Ok(at.trimmed(&balanced, point))
    }

    /// The trim of a point: angle of attack and elevator (with wings only, the angle alone) against lift and pitching moment; what
    /// symmetric flight does not do is held.
    fn symmetric(&self, name: &str, point: &FlightPoint) -> TrimCase {
        let whole = self.aircraft.file.surfaces == Surfaces::All;
        let named = |names: &[&str]| names.iter().map(|name| (*name).to_owned()).collect::<Vec<_>>();
        let mut case = TrimCase {
            name: name.to_owned(),
            v_m_s: point.v_m_s,
            given: vec![("pitch_rate_deg_s".to_owned(), point.pitch_rate_deg_s)],
            free: named(&["alpha_deg"]),
            targets: vec![(MOTIONS[2].to_owned(), point.load_factor)],
            held: named(&[MOTIONS[0], MOTIONS[1], MOTIONS[3], MOTIONS[5]]),
        };
        if whole {
            case.free.push(self.elevator());
            case.targets.push((MOTIONS[4].to_owned(), 0.0));
        } else {
            case.held.push(MOTIONS[4].to_owned());
        }
        case
    }
}
