//! Deflections that lose effect with the angle of attack: a logistic curve (the obvious form: linear).

use super::{Kind, Parameter, Sign};

pub(super) const KIND: Kind = Kind {
    name: "ctl_alpha_interaction",
    parameters: &[Parameter::size("kda_per_rad", 0.5, 5.0, Sign::Either)],
    deflection: |p, at, _, delta| {
        for (value, alpha) in delta.iter_mut().zip(at.alpha_rad) {
            *value *= 2.0 / (1.0 + (2.0 * p[0] * alpha).exp());
        }
    },
    ..Kind::NONE
};
