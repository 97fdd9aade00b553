//! Bearings or cables rub: a moment against the root's turning, whatever its speed.

use crate::effects::prelude::*;

/// Slower than this the direction of turning is not known, rad/s.
const SLOW_RAD_S: f64 = 0.02;

/// See the module.
pub(super) const FORMS: &[Declaration] = &[Declaration {
    spec: Spec {
        name: "friction",
        title: "friction at the turntable",
        side: Side::Sensor,
        rivals: &["static_hysteresis", "backlash", "cable_stiffness"],
        experiment: "a slow triangle of pitch without wind",
    },
    parameters: |_| vec![Parameter::new("c_Nm", -3.0..=0.0, 0.1)],
    loads: |p, place, state, loads| {
        if place.steady {
            return;
        }
        for (my, rate) in loads.balance[2].iter_mut().zip(&state.inputs.alpha.rate) {
            // measured rates never are zero: below a degree a second friction is taken in proportion
            *my += p[0] * (rate / SLOW_RAD_S).clamp(-1.0, 1.0);
        }
    },
    ..Declaration::NONE
}];
