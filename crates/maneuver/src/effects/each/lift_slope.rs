//! Sections lose lift per angle (viscosity), everywhere alike; control surfaces and camber keep theirs.

use super::prelude::*;

/// See the module.
#[derive(Debug)]
pub(crate) struct LiftSlope;

impl Effect for LiftSlope {
    fn spec(&self) -> &'static Spec {
        &Spec {
            name: "lift_slope",
            title: "lift slope, all along the span",
            side: Side::Aerodynamics,
            rivals: &["q_error", "tip_loss", "bend_stiff"],
            experiment: "an airspeed sweep; flap data, which an error of q changes too",
        }
    }

    fn parameters(&self) -> Vec<Parameter> {
        vec![Parameter::new("dk", (-0.6, 0.6), 0.1)]
    }

    fn change(&self, p: &[f64], _place: &Place<'_>, change: &mut Change) {
        change.lift_slope += p[0];
    }
}
