//! Zeros of the balance drift with the clock.

use crate::effects::prelude::*;

/// See the module.
pub(super) const FORMS: &[Declaration] = &[Declaration {
    spec: Spec {
        name: "drift",
        title: "zeros of the balance drift over the campaign",
        side: Side::Balance,
        rivals: &["alpha_offset", "camber"],
        experiment: "zeros without wind before and after each run; runs in random order",
    },
    parameters: |_| {
        vec![
            Parameter::new("d_fz_N_per_h", -5.0..=5.0, 0.5),
            Parameter::new("d_mx_Nm_per_h", -4.0..=4.0, 0.4),
            Parameter::new("d_my_Nm_per_h", -2.0..=2.0, 0.2),
        ]
    },
    stage: Stage::Reading,
    loads: |p, place, _, loads| {
        if !place.steady {
            let hours = |i: usize| place.clock_h + i as f64 * place.time_step_s / 3600.0;
            loads.add_to_readings(p, |rate, i, _| rate * hours(i));
        }
    },
    ..Declaration::NONE
}];
