//! Steady flight of the aircraft that really bends, beside what small deflections say of it.

use crate::aircraft::assembly::Aircraft;
use crate::error::AircraftError;
use crate::results::comparison::{Comparison, Flown};
use crate::trim::large::{LargeAircraft, LargeTrimmed};
use crate::trim::model::{FlightModel, Trimmed};
use aero::Corrections;
use schemars::JsonSchema;
use serde::Serialize;

/// Both models.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct LargeFlight {
    /// Without corrections.
    pub initial: Vec<LargePoint>,
    /// With corrections.
    pub updated: Vec<LargePoint>,
}

/// A point of steady flight in both geometries.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct LargePoint {
    /// `trim`, `pull_up` or `push_down`.
    pub name: &'static str,
    /// Airspeed.
    #[serde(rename = "V_m_s")]
    pub v_m_s: f64,
    /// Load factor.
    pub load_factor: f64,
    /// The aircraft that bends.
    pub large: BentNumbers,
    /// What small deflections say.
    pub linear: BentNumbers,
    /// Largest force that is left over, as a share of the weight at rest.
    pub force_left_over: f64,
    /// Largest moment that is left over, as a share of the weight on a mean chord; with wings only the pitching moment is not balanced.
    pub moment_left_over: f64,
    /// Newton's iterations.
    pub iterations: usize,
}

/// An aircraft in steady flight.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
pub struct BentNumbers {
    /// Angle of the wing's root.
    pub alpha_deg: f64,
    /// Elevator, trailing edge down.
    pub elevator_deg: f64,
    /// Right tip over the plane of the centre.
    pub tip_deflection_m: f64,
    /// From tip to tip along y.
    pub spread_m: f64,
    /// Bending moment at the right wing's root, weight and inertia included.
    #[serde(rename = "right_root_Mx_Nm")]
    pub right_root_mx_nm: f64,
}

impl Aircraft {
    /// The steady points of a comparison with large deflections; `wing` are the corrections it was made with, `found` the aircraft whose
    /// structure was found, if the updated model has another.
    ///
    /// # Errors
    /// If something in the structure cannot turn far, or a point has no balanced equilibrium.
    pub fn large_flight(
        &self,
        found: Option<&Self>,
        wing: &Corrections,
        linear: &Comparison,
    ) -> Result<LargeFlight, AircraftError> {
        let body = self.large()?;
        let initial = self.large_points(&body, &self.uncorrected(), &linear.initial)?;
        let body = if let Some(found) = found { found.large()? } else { body };
        let own = found.unwrap_or(self);
        let updated = own.large_points(&body, &own.with_corrections(wing)?, &linear.updated)?;
        Ok(LargeFlight { initial, updated })
    }

    fn large_points(
        &self,
        body: &LargeAircraft<'_>,
        model: &FlightModel<'_>,
        flown: &Flown,
    ) -> Result<Vec<LargePoint>, AircraftError> {
        let each = [("trim", &flown.trim), ("pull_up", &flown.pull_up), ("push_down", &flown.push_down)];
        let point = |(name, linear): (&'static str, &Trimmed)| {
            let large = body.trim(model, &linear.point)?;
            Ok(LargePoint {
                name,
                v_m_s: linear.point.v_m_s,
                load_factor: linear.point.load_factor,
                force_left_over: large.unbalanced[0],
                moment_left_over: large.unbalanced[1],
                iterations: large.flight.iterations,
                large: large.numbers(),
                linear: self.linear_numbers(linear),
            })
        };
        each.into_iter().map(point).collect()
    }

    fn linear_numbers(&self, trimmed: &Trimmed) -> BentNumbers {
        let y = |node: usize| self.free.points()[node].y;
        BentNumbers {
            alpha_deg: trimmed.alpha_rad.to_degrees(),
            elevator_deg: trimmed.elevator_rad.to_degrees(),
            tip_deflection_m: trimmed.tip_deflection_m[0],
            spread_m: y(self.right.tip) - y(self.left.tip),
            right_root_mx_nm: trimmed.root_loads[0].mx_nm,
        }
    }
}

impl LargeTrimmed {
    /// The point in numbers.
    pub fn numbers(&self) -> BentNumbers {
        BentNumbers {
            alpha_deg: self.alpha_rad.to_degrees(),
            elevator_deg: self.elevator_rad.to_degrees(),
            tip_deflection_m: self.tip_deflection_m[0],
            spread_m: self.spread_m,
            right_root_mx_nm: self.root_loads[0].mx_nm,
        }
    }
}
