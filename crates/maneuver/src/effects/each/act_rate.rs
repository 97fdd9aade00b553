//! Servos turn no faster than a rate; the parameter is its inverse, so that zero is no limit.

use super::prelude::*;

/// See the module.
#[derive(Debug)]
pub(crate) struct ActRate;

impl Effect for ActRate {
    fn spec(&self) -> &'static Spec {
        &Spec {
            name: "act_rate",
            title: "servos have a largest rate",
            side: Side::Control,
            rivals: &["ctl_saturation", "act_lag"],
            experiment: "a slow triangle of the flap beside the doublet",
        }
    }

    fn parameters(&self) -> Vec<Parameter> {
        vec![Parameter::new("inverse_rate_s_per_rad", (0.0, 3.0), 0.5)]
    }

    fn inputs(&self, p: &[f64], place: &Place<'_>, inputs: &mut Inputs) {
        if !place.steady && p[0] > 0.0 {
            for control in &mut inputs.controls_rad {
                *control = signal::rate_limited(control, place.time_step_s, 1.0 / p[0]);
            }
        }
    }
}
