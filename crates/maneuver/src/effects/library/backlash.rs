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
    surfaces: |p, place, angles| {
        if !place.steady && p[0] > 0.0 {
            for surface in &mut angles.controls_rad {
                *surface = signal::freeplay(surface, p[0].to_radians());
            }
        }
    },
    ..Declaration::NONE
}];
