//! What every effect's file needs.

pub(super) use crate::effects::place::REFERENCE_V_M_S;
pub(super) use crate::effects::{
    Effect, Forces, Inputs, Loads, Parameter, Place, Seen, Side, Spec, Stage, signal,
};
pub(super) use crate::rom::{Change, Constants, PointMass};

/// What a strip loses of its lift, N, beyond a limit of its effective angle: `k/(1 + k)` of what exceeds it.
pub(super) fn stalled(lift_n: f64, by_angle: f64, limit_rad: f64, k: f64) -> f64 {
    let angle = if by_angle > 0.0 { lift_n / by_angle } else { 0.0 };
    k / (1.0 + k) * (angle.abs() - limit_rad).max(0.0) * angle.signum() * by_angle
}

/// Lift of a zone per rad of its own effective angle, N: two pi for the section.
pub(super) fn lift_by_angle(place: &Place<'_>, zone: usize) -> f64 {
    std::f64::consts::TAU * place.q_pa() * place.zones.area_m2[zone]
}
