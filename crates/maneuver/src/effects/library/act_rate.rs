//! Servos turn no faster than a rate; the parameter is its inverse, so that zero is no limit.
//!
//! Two forms: the servo's electronics let the command change no faster, or (`behind the servo`) its motor turns the surface no
//! faster than that, whatever its loop asks for.

use crate::effects::prelude::*;

/// See the module.
pub(super) const FORMS: &[Declaration] = &[
    COMMAND,
    Declaration { form: "behind the servo", inputs: Declaration::NONE.inputs, surfaces: limit, ..COMMAND },
];

const COMMAND: Declaration = Declaration {
    spec: Spec {
        name: "act_rate",
        title: "servos have a largest rate",
        side: Side::Control,
        rivals: &["ctl_saturation", "act_lag"],
        experiment: "a slow triangle of the flap beside the doublet",
    },
    parameters: |_| vec![Parameter::new("inverse_rate_s_per_rad", 0.0..=3.0, 0.5)],
    inputs: limit,
    ..Declaration::NONE
};

/// Limits the rate of commands or of surfaces.
fn limit(p: &[f64], place: &Place<'_>, angles: &mut Inputs) {
    if !place.steady && p[0] > 0.0 {
        for control in &mut angles.controls_rad {
            *control = signal::rate_limited(control, place.time_step_s, 1.0 / p[0]);
        }
    }
}
