//! A loss of lift slope that waves along the span (the obvious form: the same everywhere); flaps keep theirs.

use super::{Kind, Parameter, Sign};

pub(super) const KIND: Kind = Kind {
    name: "lift_slope",
    parameters: &[Parameter::size("dk", 0.008, 0.35, Sign::Either)],
    physics: |p, wing, _, physics| {
        if p[0] == 0.0 {
            return;
        }
        for (lift, eta) in physics.lift.iter_mut().zip(&wing.strips.eta) {
            *lift *= 1.0 + p[0] * (1.0 + 0.12 * (std::f64::consts::PI * eta).cos());
        }
        for flap in &mut physics.flap {
            *flap /= 1.0 + p[0];
        }
    },
    ..Kind::NONE
};
