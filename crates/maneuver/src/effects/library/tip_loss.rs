//! Lift is lost towards the tip: a factor `1 - d (y/L)²` on the forces of the air.

use crate::effects::prelude::*;

/// See the module.
pub(super) const FORMS: &[Declaration] = &[Declaration {
    spec: Spec {
        name: "tip_loss",
        title: "lift lost towards the tip",
        side: Side::Aerodynamics,
        rivals: &["lift_slope", "q_error", "bend_stiff"],
        experiment: "Mx/Fz over airspeed: elastic washout scales with q, tip loss does not",
    },
    parameters: |_| vec![Parameter::new("dt", -0.9..=0.9, 0.2)],
    change: |p, place, change| {
        for (force, y) in change.zone_force.iter_mut().zip(&place.zones.y_norm) {
            *force -= p[0] * y * y;
        }
    },
    flight: Flight::Corrections,
    correct: |p, air| air.lose_to_tip(p[0]),
    ..Declaration::NONE
}];
