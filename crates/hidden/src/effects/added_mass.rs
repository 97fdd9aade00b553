//! Another apparent mass, more so inboard (the obvious form: one factor).

use super::{Kind, Parameter, Sign};

pub(super) const KIND: Kind = Kind {
    name: "added_mass",
    parameters: &[Parameter::size("dam", 0.06, 0.9, Sign::Either)],
    physics: |p, wing, _, physics| {
        for (factor, eta) in physics.apparent_mass.iter_mut().zip(&wing.strips.eta) {
            *factor *= 1.0 + p[0] * (1.06 - 0.12 * eta);
        }
    },
    ..Kind::NONE
};
