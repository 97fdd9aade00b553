//! Bearings or cables rub: a moment against the root's turning.
//!
//! Two forms. Dry: whatever the speed, but for the slowest. `smooth`: it grows with the speed and levels off beyond a rate, as
//! greased bearings and bundles of cables do; the rate comes on top of the slowest.

use crate::effects::prelude::*;

/// Slower than this the direction of turning is not known, rad/s.
const SLOW_RAD_S: f64 = 0.02;

/// See the module.
pub(super) const FORMS: &[Declaration] = &[
    DRY,
    Declaration {
        form: "smooth",
        parameters: |_| vec![moment(), Parameter::new("level_rad_s", 0.0..=0.5, 0.1)],
        loads: |p, place, state, loads| {
            rub(p[0], place, state, loads, |rate| (rate / (SLOW_RAD_S + p[1])).tanh());
        },
        ..DRY
    },
];

const DRY: Declaration = Declaration {
    spec: Spec {
        name: "friction",
        title: "friction at the turntable",
        side: Side::Sensor,
        rivals: &["static_hysteresis", "backlash", "cable_stiffness"],
        experiment: "a slow triangle of pitch without wind",
    },
    parameters: |_| vec![moment()],
    // measured rates never are zero: below a degree a second friction is taken in proportion
    loads: |p, place, state, loads| {
        rub(p[0], place, state, loads, |rate| (rate / SLOW_RAD_S).clamp(-1.0, 1.0));
    },
    ..Declaration::NONE
};

fn moment() -> Parameter {
    Parameter::new("c_Nm", -3.0..=0.0, 0.1)
}

/// Adds a moment (N m) by the share of it that acts at a rate (rad/s).
fn rub(
    moment_nm: f64,
    place: &Place<'_>,
    state: &WingState<'_>,
    loads: &mut Loads,
    share: impl Fn(f64) -> f64,
) {
    if place.steady {
        return;
    }
    for (my, rate) in loads.balance[2].iter_mut().zip(&state.inputs.alpha.rate) {
        *my += moment_nm * share(*rate);
    }
}
