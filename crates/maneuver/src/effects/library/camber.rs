//! Zero-lift angle and zero-lift moment of the sections are off (camber, twist): f_j^e/q of the calibration.

use crate::effects::prelude::*;

/// See the module.
pub(super) const FORMS: &[Declaration] = &[Declaration {
    spec: Spec {
        name: "camber",
        title: "zero-lift angle or moment of the sections",
        side: Side::Aerodynamics,
        rivals: &["alpha_offset", "drift", "delta_offset"],
        experiment: "My at zero lift over airspeed; an inverted run",
    },
    parameters: |_| {
        vec![Parameter::new("dcl0_deg", -4.0..=4.0, 0.5), Parameter::new("dcm0", -0.1..=0.1, 0.01)]
    },
    inputs: |p, place, inputs| inputs.incline(place, p[0].to_radians()),
    constants: |p, _, constants| constants.moment_coefficient += p[1],
    flight: Flight::Corrections,
    correct: |p, air| {
        air.incline(p[0].to_radians());
        air.add_moment(p[1]);
    },
    ..Declaration::NONE
}];
