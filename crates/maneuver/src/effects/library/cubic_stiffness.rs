//! The wing stiffens as it bends: the first mode's stiffness times `1 + k3 z²`, z the tip's height.

use crate::effects::prelude::*;

/// See the module.
pub(super) const FORMS: &[Declaration] = &[Declaration {
    spec: Spec {
        name: "cubic_stiffness",
        title: "bending stiffens with deflection",
        side: Side::Structure,
        rivals: &["stall", "large_deflection"],
        experiment: "amplitudes at resonance, without wind",
    },
    parameters: |_| vec![Parameter::new("k3_per_m2", 0.0..=20.0, 3.0)],
    needs: Needs::OUTER_HEIGHT,
    forces: |p, place, state, forces| {
        forces.push_first_mode(place, state, |z| -(p[0] * z * z * place.first_stiffness * z));
    },
    ..Declaration::NONE
}];
