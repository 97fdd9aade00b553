//! Lift slope and zero-lift angle change with Reynolds number, hence with airspeed, beyond dynamic pressure:
//! factors of `V_ref/V - 1`.

use crate::effects::prelude::*;

/// See the module.
pub(super) const FORMS: &[Declaration] = &[Declaration {
    spec: Spec {
        name: "re_dependence",
        title: "low Reynolds number changes slope and zero lift",
        side: Side::Aerodynamics,
        rivals: &["bend_stiff", "tors_stiff", "q_error"],
        experiment: "trip strips; five airspeeds or more",
    },
    parameters: |_| vec![Parameter::new("r", -0.5..=0.5, 0.1), Parameter::new("r0_deg", -3.0..=3.0, 0.5)],
    inputs: |p, place, inputs| {
        inputs.incline(place, p[1].to_radians() * (REFERENCE_V_M_S / place.flow.v_m_s - 1.0));
    },
    change: |p, place, change| {
        if place.flow.v_m_s > 0.0 {
            change.lift_slope += p[0] * (REFERENCE_V_M_S / place.flow.v_m_s - 1.0);
        }
    },
    flight: Flight::Corrections,
    correct: |p, air| {
        air.scale_slope(p[0] * air.slower());
        air.incline(p[1].to_radians() * air.slower());
    },
    ..Declaration::NONE
}];
