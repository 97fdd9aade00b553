//! Controls with less or more effect, not all alike (the obvious form: one factor).

use super::{Kind, Parameter, Sign};

pub(super) const KIND: Kind = Kind {
    name: "ctl_scale",
    parameters: &[Parameter::size("deta", 0.01, 0.4, Sign::Either)],
    physics: |p, _, _, physics| {
        for (control, flap) in physics.flap.iter_mut().enumerate() {
            *flap *= 1.0 + p[0] * (1.06 - 0.06 * control as f64);
        }
    },
    ..Kind::NONE
};
