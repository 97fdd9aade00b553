//! Freeplay in the linkage of the control surfaces: between the servo, whose overshoot takes some of it up, and the surface.
//!
//! Two forms. By what the servo did before: the surface stays where it is until the gap is used up. `pressed by the air`: with
//! wind the surface's hinge moment holds it at that end of the gap where it is deflected less, so that half the gap is missing
//! from every deflection, at rest as well, and nothing of smaller ones is left.

use crate::effects::prelude::*;

/// See the module.
pub(super) const FORMS: &[Declaration] = &[
    PLAY,
    Declaration {
        form: "pressed by the air",
        surfaces: |p, place, angles| {
            let half = 0.5 * p[0].to_radians();
            if place.flow.v_m_s > 0.0 && half > 0.0 {
                for delta in angles.deflections() {
                    *delta -= delta.clamp(-half, half);
                }
            }
        },
        excludes_deflection_correction: true,
        ..PLAY
    },
];

const PLAY: Declaration = Declaration {
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
};
