//! Servos turn no faster than a rate; the parameter is its inverse, so that zero is no limit.

use crate::effects::prelude::*;

/// See the module.
pub(super) const FORMS: &[Declaration] = &[Declaration {
    spec: Spec {
        name: "act_rate",
        title: "servos have a largest rate",
        side: Side::Control,
        rivals: &["ctl_saturation", "act_lag"],
        experiment: "a slow triangle of the flap beside the doublet",
    },
    parameters: |_| vec![Parameter::new("inverse_rate_s_per_rad", 0.0..=3.0, 0.5)],
    inputs: |p, place, inputs| {
        if !place.steady && p[0] > 0.0 {
            for control in &mut inputs.controls_rad {
                *control = signal::rate_limited(control, place.time_step_s, 1.0 / p[0]);
            }
        }
    },
    ..Declaration::NONE
}];
