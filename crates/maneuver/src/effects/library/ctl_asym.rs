//! Control surfaces do more one way than the other.

use crate::effects::prelude::*;

/// See the module.
pub(super) const FORMS: &[Declaration] = &[Declaration {
    spec: Spec {
        name: "ctl_asym",
        title: "up and down deflections differ",
        side: Side::Control,
        rivals: &["camber", "ctl_saturation"],
        experiment: "a static sweep of the flap, both ways",
    },
    parameters: |_| vec![Parameter::new("ka", -0.6..=0.6, 0.1)],
    inputs: |p, _, inputs| {
        for delta in inputs.deflections().filter(|delta| **delta > 0.0) {
            *delta *= 1.0 - p[0];
        }
    },
    excludes_deflection_correction: true,
    ..Declaration::NONE
}];
