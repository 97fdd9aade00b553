//! Lift is lost towards the tip: a factor `1 - d (y/L)²` on the forces of the air.

use super::prelude::*;

/// See the module.
#[derive(Debug)]
pub(crate) struct TipLoss;

impl Effect for TipLoss {
    fn spec(&self) -> &'static Spec {
        &Spec {
            name: "tip_loss",
            title: "lift lost towards the tip",
            side: Side::Aerodynamics,
            rivals: &["lift_slope", "q_error", "bend_stiff"],
            experiment: "Mx/Fz over airspeed: elastic washout scales with q, tip loss does not",
        }
    }

    fn parameters(&self) -> Vec<Parameter> {
        vec![Parameter::new("dt", (-0.9, 0.9), 0.2)]
    }

    fn change(&self, p: &[f64], place: &Place<'_>, change: &mut Change) {
        for (force, y) in change.zone_force.iter_mut().zip(&place.zones.y_norm) {
            *force -= p[0] * y * y;
        }
    }
}
