//! Freeplay in the linkage of the control surfaces: between the servo, whose overshoot takes some of it up, and the surface.

use crate::effects::prelude::*;

/// See the module.
pub(super) const FORMS: &[Declaration] = &[Declaration {
    spec: Spec {
        name: "backlash",
        title: "freeplay in the linkage",
        side: Side::Control,
        rivals: &["ctl_scale", "ctl_saturation"],
        experiment: "amplitudes from 1 to 5 degrees; a slow triangle",
    },
    parameters: |_| vec![Parameter::new("gap_deg", 0.0..=3.0, 1.0)],
    inputs,
    ..Declaration::NONE
}];

fn inputs(p: &[f64], place: &Place<'_>, inputs: &mut Inputs) {
    if place.steady || p[0] <= 0.0 {
        return;
    }
    for control in &mut inputs.controls_rad {
        let turned = signal::damped(control, place.time_step_s, place.actuator);
        let surface = signal::freeplay(&turned, p[0].to_radians());
        // the command to which a surface without freeplay would answer so, but for the servo's lag of the difference
        for (command, (after, before)) in control.iter_mut().zip(surface.iter().zip(&turned)) {
            *command += after - before;
        }
    }
}
