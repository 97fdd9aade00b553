//! Sections lose lift per angle (viscosity), everywhere alike; control surfaces keep theirs. Camber keeps its lift, too, or
//! loses as much of it (the other form).

use super::prelude::*;

/// See the module.
#[derive(Debug)]
pub(crate) struct LiftSlope {
    /// Whether the lift of camber and twist changes with it.
    pub(crate) with_camber: bool,
}

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

    fn form(&self) -> &'static str {
        if self.with_camber { "with camber" } else { "angle alone" }
    }

    fn parameters(&self) -> Vec<Parameter> {
        vec![Parameter::new("dk", (-0.6, 0.6), 0.1)]
    }

    fn change(&self, p: &[f64], _place: &Place<'_>, change: &mut Change) {
        if self.with_camber {
            change.zone_force.iter_mut().for_each(|factor| *factor += p[0]);
        } else {
            change.lift_slope += p[0];
        }
    }

    fn inputs(&self, p: &[f64], _place: &Place<'_>, inputs: &mut Inputs) {
        if self.with_camber && p[0] != 0.0 {
            // what zones lose of all lift, surfaces are given back
            let back = 1.0 / (1.0 + p[0]).max(0.1);
            inputs.controls_rad.iter_mut().flatten().for_each(|delta| *delta *= back);
        }
    }
}
