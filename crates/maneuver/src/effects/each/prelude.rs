//! What every effect's file needs.

pub(super) use crate::compact::{Change, Constants, PointMass};
pub(super) use crate::effects::place::REFERENCE_V_M_S;
pub(super) use crate::effects::{Effect, Forces, Inputs, Loads, Parameter, Place, Seen, Side, Spec, signal};

/// Lift of a zone per rad of its own effective angle, N: two pi for the section.
pub(super) fn lift_by_angle(place: &Place<'_>, zone: usize) -> f64 {
    std::f64::consts::TAU * place.q_pa() * place.zones.area_m2[zone]
}
