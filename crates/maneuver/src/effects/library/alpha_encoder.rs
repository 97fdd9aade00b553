//! The angle's encoder reads too much or too little, or late: the wing's own angle is another. Gravity is left at the
//! reading.

use crate::effects::prelude::*;

/// See the module.
pub(super) const FORMS: &[Declaration] = &[Declaration {
    spec: Spec {
        name: "alpha_encoder",
        title: "gain or lag of the angle sensor",
        side: Side::Sensor,
        rivals: &["lift_slope", "delay", "aero_lag"],
        experiment: "a tilt without wind beside an inclinometer",
    },
    parameters: |_| {
        vec![Parameter::new("g_a", -0.2..=0.2, 0.03), Parameter::new("tau_a_s", -0.05..=0.05, 0.01)]
    },
    inputs: |p, place, inputs| {
        for values in [&mut inputs.alpha.value, &mut inputs.alpha.rate, &mut inputs.alpha.second] {
            if !place.steady && p[1] != 0.0 {
                *values = signal::delayed(values, place.time_step_s, p[1]);
            }
            for value in values.iter_mut() {
                *value += p[0] * *value;
            }
        }
    },
    ..Declaration::NONE
}];
