//! Bearings or cables rub: a moment against the root's turning, whatever its speed.

use super::prelude::*;

/// Slower than this the direction of turning is not known, rad/s.
const SLOW_RAD_S: f64 = 0.02;

/// See the module.
#[derive(Debug)]
pub(crate) struct Friction;

impl Effect for Friction {
    fn spec(&self) -> &'static Spec {
        &Spec {
            name: "friction",
            title: "friction at the turntable",
            side: Side::Sensor,
            rivals: &["static_hysteresis", "backlash", "cable_stiffness"],
            experiment: "a slow triangle of pitch without wind",
        }
    }

    fn parameters(&self) -> Vec<Parameter> {
        vec![Parameter::new("c_Nm", (-3.0, 0.0), 0.1)]
    }

    fn loads(&self, p: &[f64], place: &Place<'_>, seen: &Seen<'_>, loads: &mut Loads) {
        if place.steady {
            return;
        }
        for i in 0..seen.len() {
            // measured rates never are zero: below a degree a second friction is taken in proportion
            let rate = seen.inputs.alpha.rate[i];
            loads.balance[2][i] += p[0] * (rate / SLOW_RAD_S).clamp(-1.0, 1.0);
        }
    }
}
