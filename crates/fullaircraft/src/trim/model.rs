//! The aircraft with corrections of its wings, and what it is in balanced flight.

use crate::aircraft::assembly::Aircraft;
use crate::aircraft::file::FlightPoint;
use crate::error::AircraftError;
use aero::{Corrections, Flow};
use coupling::{CouplingError, RootLoads, SupportedStructure};
use faer::{Mat, MatRef};
use nalgebra::Point3;
use std::sync::OnceLock;

/// An aircraft with corrections of its wings.
#[derive(Debug)]
pub struct FlightModel<'a> {
    /// The aircraft.
    pub aircraft: &'a Aircraft,
    /// Corrections of all boxes in the flow.
    pub corrections: Corrections,
    /// Density of the air, kg/m³: that of the aircraft's file, or another altitude's.
    pub rho_kg_m3: f64,
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
            rho_kg_m3: self.file.rho_kg_m3,
            divergence_pa: OnceLock::new(),
        })
    }

    /// The aircraft as modelled before any measurement.
    pub fn uncorrected(&self) -> FlightModel<'_> {
        FlightModel {
            aircraft: self,
            corrections: Corrections::neutral(self.flow.lattice.len()),
            rho_kg_m3: self.file.rho_kg_m3,
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
    /// The same in air of another density, kg/m³.
    #[must_use]
    pub fn in_air(self, rho_kg_m3: f64) -> Self {
        Self { rho_kg_m3, ..self }
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
        Flow { v_m_s: point.v_m_s, rho_kg_m3: self.rho_kg_m3 }
    }

    /// Box loads of pressures, the pressure offset in the first column.
    pub(crate) fn loads(&self, q_pa: f64, cp: MatRef<'_, f64>) -> Mat<f64> {
        let operator = self.aircraft.flow.integration.corrected(&self.corrections);
        let mut loads = operator.of_pressures(q_pa, cp);
        operator.add_offset(q_pa, &mut loads, 0);
        loads
    }
}
