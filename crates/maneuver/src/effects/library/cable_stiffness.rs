//! Cables and tubes across the balance are a spring against turning.

use crate::effects::prelude::*;

/// See the module.
pub(super) const FORMS: &[Declaration] = &[Declaration {
    spec: Spec {
        name: "cable_stiffness",
        title: "stiffness of cables across the balance",
        side: Side::Sensor,
        rivals: &["joiner_inertia", "friction"],
        experiment: "a tilt without wind, with and without cables",
    },
    parameters: |_| vec![Parameter::new("k_c_Nm_per_rad", 0.0..=20.0, 3.0)],
    loads: |p, _, state, loads| {
        for (my, alpha) in loads.balance[2].iter_mut().zip(&state.inputs.alpha.value) {
            *my -= p[0] * alpha;
        }
    },
    ..Declaration::NONE
}];
