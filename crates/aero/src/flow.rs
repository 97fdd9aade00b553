//! The undisturbed stream.

use serde::{Deserialize, Serialize};

/// Airspeed and density of the undisturbed stream.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Flow {
    /// True airspeed, m/s.
    pub v_m_s: f64,
    /// Density, kg/m3.
    pub rho_kg_m3: f64,
}

impl Flow {
    /// Dynamic pressure rho V^2/2, Pa.
    pub fn dynamic_pressure_pa(&self) -> f64 {
        0.5 * self.rho_kg_m3 * self.v_m_s * self.v_m_s
    }
}
