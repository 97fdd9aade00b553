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

use crate::aircraft::assembly::Aircraft;
use crate::aircraft::file::{FlightPoint, Surfaces};
use crate::error::AircraftError;
use crate::trim::case::{TrimCase, TrimTools};
use crate::trim::variables::MOTIONS;
use aero::{Corrections, Flow};
use coupling::{CouplingError, GRAVITY_M_S2, RootLoads, SupportedStructure};
use faer::{Mat, MatRef};
use nalgebra::Point3;
use std::sync::OnceLock;

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

/// An aircraft with corrections of its wings.
#[derive(Debug)]
pub struct FlightModel<'a> {
    /// The aircraft.
    pub aircraft: &'a Aircraft,
    /// Corrections of all boxes in the flow.
    pub corrections: Corrections,
    /// Lowest divergence pressure, Pa, once it has been asked for.
    divergence_pa: OnceLock<Option<f64>>,
}

/// The aircraft in balanced flight.
#[derive(Debug, Clone)]
pub struct Trimmed {
    /// Where.
    pub point: FlightPoint,
    /// Angle of the centre (the wing's root) against the flow, rad.
    pub alpha_rad: f64,
    /// Elevator, trailing edge down, rad; zero with wings only.
    pub elevator_rad: f64,
    /// Height of the right and left tip over the plane of the centre, m.
    pub tip_deflection_m: [f64; 2],
    /// Displacement of the s-set (the degrees of freedom the boxes follow) against the centre, m and rad.
    pub displacement: Vec<f64>,
    /// Corrected box loads, two a box, N and N m.
    pub box_loads: Vec<f64>,
    /// Lift, N.
    pub fz_n: f64,
    /// Pitching moment about the centre of gravity, nose up, N m: what wings alone leave unbalanced.
    pub my_nm: f64,
    /// What right and left wing put on the fuselage, weight and inertia included, about the wing's balance
    /// point, aircraft axes on both sides (so Mx of the left wing is negative under lift).
    pub root_loads: [RootLoads; 2],
}

impl Aircraft {
    /// The aircraft with corrections of one wing's boxes, mirrored to the other.
    ///
    /// # Errors
    /// If there is not one entry for each box of the wing.
    pub fn with_corrections(&self, wing: &Corrections) -> Result<FlightModel<'_>, AircraftError> {
        Ok(FlightModel {
            aircraft: self,
            corrections: self.corrections(wing)?,
            divergence_pa: OnceLock::new(),
        })
    }

    /// The aircraft as modelled before any measurement.
    pub fn uncorrected(&self) -> FlightModel<'_> {
        FlightModel {
            aircraft: self,
            corrections: Corrections::neutral(self.flow.lattice.len()),
            divergence_pa: OnceLock::new(),
        }
    }

    /// The structure held at the centre.
    pub(crate) fn held(&self) -> Result<&SupportedStructure, AircraftError> {
        let missing = CouplingError::Size { what: "held structures", got: 0, expected: 1 };
        self.flow.supported.as_ref().ok_or_else(|| missing.into())
    }

    /// The point a wing's root loads are about: the balance of the wing's file.
    pub fn root_point(&self) -> Point3<f64> {
        let balance = &self.wing.balance;
        Point3::new(balance.x_m, balance.y_m, balance.z_m)
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

    /// Name of the elevator's variable.
    pub(crate) fn elevator(&self) -> String {
        format!("{}_deg", self.aircraft.file.htp.control.name)
    }

    /// Lowest dynamic pressure at which the aircraft, held at the wing's root, diverges, Pa; `None` if there is none. By
    /// eigenvalues: a mirrored aircraft has them in pairs close together, between which a determinant's sign tells nothing.
    ///
    /// # Errors
    /// If the eigenvalues do not converge.
    pub fn divergence_pressure_pa(&self) -> Result<Option<f64>, AircraftError> {
        if let Some(known) = self.divergence_pa.get() {
            return Ok(*known);
        }
        let found = self.aircraft.flow.divergence_pressure(&self.corrections)?;
        Ok(*self.divergence_pa.get_or_init(|| found))
    }

    /// Airspeed and density of a point.
    pub fn flow(&self, point: &FlightPoint) -> Flow {
        Flow { v_m_s: point.v_m_s, rho_kg_m3: self.aircraft.file.rho_kg_m3 }
    }

    /// Box loads of pressures, the pressure offset in the first column.
    pub(crate) fn loads(&self, q_pa: f64, cp: MatRef<'_, f64>) -> Mat<f64> {
        let operator = self.aircraft.flow.integration.corrected(&self.corrections);
        let mut loads = operator.of_pressures(q_pa, cp);
        operator.add_offset(q_pa, &mut loads, 0);
        loads
    }
}
