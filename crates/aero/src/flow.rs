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

/// Airspeeds closer than this share are one: loads at them differ by 0.4 % at most, which is less than a balance's repeatability.
pub const SAME_AIRSPEED: f64 = 0.002;
/// Angles of attack closer than this are one, rad (0.05 degrees): a turntable is set no better.
pub const SAME_ANGLE_RAD: f64 = 8.7e-4;

/// An airspeed this share below or above those of a schedule takes the nearest one's values, as tunnels stray; farther out
/// none are taken.
pub const STRAY_AIRSPEED: f64 = 0.02;

/// Whether two airspeeds (m/s) are one condition.
pub fn same_airspeed(a: f64, b: f64) -> bool {
    (a - b).abs() <= SAME_AIRSPEED * a.max(b)
}

/// Whether two angles of attack (rad) are one condition.
pub fn same_angle(a: f64, b: f64) -> bool {
    (a - b).abs() <= SAME_ANGLE_RAD
}
