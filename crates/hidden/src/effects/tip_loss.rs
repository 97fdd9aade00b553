//! A loss towards the tip with a power of its own (the obvious form: the square of the span).

use super::{Kind, Parameter, Sign};

pub(super) const KIND: Kind = Kind {
    name: "tip_loss",
    parameters: &[Parameter::size("dt", 0.02, 0.7, Sign::Either)],
    physics: |p, wing, _, physics| {
        for (lift, eta) in physics.lift.iter_mut().zip(&wing.strips.eta) {
            *lift *= 1.0 - p[0] * (0.45 * eta.powf(1.5) + 0.55 * eta.powi(3));
        }
    },
    ..Kind::NONE
};
