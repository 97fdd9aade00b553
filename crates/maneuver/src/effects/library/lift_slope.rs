//! Sections lose lift per angle (viscosity), everywhere alike; control surfaces keep theirs. Camber keeps its lift, too, or
//! loses as much of it (the other form). In flight both forms leave camber its lift.

use crate::effects::prelude::*;

/// See the module.
pub(super) const FORMS: &[Declaration] = &[
    ANGLE_ALONE,
    Declaration {
        form: "with camber",
        change: |p, _, change| change.zone_force.iter_mut().for_each(|factor| *factor += p[0]),
        inputs: |p, _, inputs| {
            if p[0] != 0.0 {
                // what zones lose of all lift, surfaces are given back
                let back = 1.0 / (1.0 + p[0]).max(0.1);
                inputs.deflections().for_each(|delta| *delta *= back);
            }
        },
        ..ANGLE_ALONE
    },
];

const ANGLE_ALONE: Declaration = Declaration {
    spec: Spec {
        name: "lift_slope",
        title: "lift slope, all along the span",
        side: Side::Aerodynamics,
        rivals: &["q_error", "tip_loss", "bend_stiff"],
        experiment: "an airspeed sweep; flap data, which an error of q changes too",
    },
    form: "angle alone",
    parameters: |_| vec![Parameter::new("dk", -0.6..=0.6, 0.1)],
    change: |p, _, change| change.lift_slope += p[0],
    flight: Flight::Corrections,
    correct: |p, air| air.scale_slope(p[0]),
    ..Declaration::NONE
};
