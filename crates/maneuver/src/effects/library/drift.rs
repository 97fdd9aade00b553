//! Zeros of the balance drift with the clock: steadily, or (`warming up`) ever slower, as strain gauges and amplifiers settle
//! after they are switched on.

use crate::effects::prelude::*;

/// What is left to settle falls to a third (1/e) in this time, h: amplifiers and gauges are given an hour or two before a test.
const SETTLING_H: f64 = 0.5;

/// See the module.
pub(super) const FORMS: &[Declaration] = &[
    STEADY,
    Declaration {
        form: "warming up",
        parameters: |_| parameters(["d_fz_N", "d_mx_Nm", "d_my_Nm"]),
        loads: |p, place, _, loads| shift(p, place, loads, |hours| -(-hours / SETTLING_H).exp_m1()),
        ..STEADY
    },
];

const STEADY: Declaration = Declaration {
    spec: Spec {
        name: "drift",
        title: "zeros of the balance drift over the campaign",
        side: Side::Balance,
        rivals: &["alpha_offset", "camber"],
        experiment: "zeros without wind before and after each run; runs in random order",
    },
    parameters: |_| parameters(["d_fz_N_per_h", "d_mx_Nm_per_h", "d_my_Nm_per_h"]),
    stage: Stage::Reading,
    loads: |p, place, _, loads| shift(p, place, loads, |hours| hours),
    ..Declaration::NONE
};

fn parameters([fz, mx, my]: [&str; 3]) -> Vec<Parameter> {
    vec![
        Parameter::new(fz, -5.0..=5.0, 0.5),
        Parameter::new(mx, -4.0..=4.0, 0.4),
        Parameter::new(my, -2.0..=2.0, 0.2),
    ]
}

/// Adds to each channel its parameter times what has come of the drift after so many hours; blocks of static points have zeros
/// of their own.
fn shift(p: &[f64], place: &Place<'_>, loads: &mut Loads, come: impl Fn(f64) -> f64) {
    if !place.steady {
        let hours = |i: usize| place.clock_h + i as f64 * place.time_step_s / 3600.0;
        loads.add_to_readings(p, |size, i, _| size * come(hours(i)));
    }
}
