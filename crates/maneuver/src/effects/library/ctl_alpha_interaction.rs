//! Control surfaces do less at angle of attack.

use crate::effects::prelude::*;

/// See the module.
pub(super) const FORMS: &[Declaration] = &[Declaration {
    spec: Spec {
        name: "ctl_alpha_interaction",
        title: "effectiveness falls with angle of attack",
        side: Side::Control,
        rivals: &["stall", "ctl_scale"],
        experiment: "angles and deflections in a factorial",
    },
    parameters: |_| vec![Parameter::new("kda_per_rad", -6.0..=6.0, 1.0)],
    inputs: |p, _, inputs| {
        for control in &mut inputs.controls_rad {
            for (delta, alpha) in control.iter_mut().zip(&inputs.alpha.value) {
                *delta *= (1.0 - p[0] * alpha).max(0.0);
            }
        }
    },
    excludes_deflection_correction: true,
    ..Declaration::NONE
}];
