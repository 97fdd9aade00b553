//! Lift of strips whose flow separates, which several effects share.

use super::place::Place;

/// The angle from which on lift grows less, rad, by how far below 16 degrees it lies: so that zero is no stall.
pub(super) fn limit_rad(earlier_than_16_deg: f64) -> f64 {
    (16.0 - earlier_than_16_deg).to_radians()
}

/// What a strip loses of its lift, N, beyond a limit of its effective angle: `k/(1 + k)` of what exceeds it.
pub(super) fn stalled(lift_n: f64, by_angle: f64, limit_rad: f64, k: f64) -> f64 {
    let angle = if by_angle > 0.0 { lift_n / by_angle } else { 0.0 };
    k / (1.0 + k) * (angle.abs() - limit_rad).max(0.0) * angle.signum() * by_angle
}

/// Lift of a zone per rad of its own effective angle, N: two pi for the section.
pub(super) fn lift_by_angle(place: &Place<'_>, zone: usize) -> f64 {
    std::f64::consts::TAU * place.q_pa() * place.zones.area_m2[zone]
}

#[cfg(test)]
mod tests;
