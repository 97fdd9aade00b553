//! Cables across the balance that pull back, stiffening with the angle (the obvious form: a spring).

use super::{Kind, Parameter, Sign};

pub(super) const KIND: Kind = Kind {
    name: "cable_stiffness",
    parameters: &[Parameter::size("k_c_Nm_per_rad", 0.5, 20.0, Sign::Plus)],
    balance: |p, at, flown| {
        for (my, alpha) in flown.loads[2].iter_mut().zip(at.alpha_rad) {
            *my -= p[0] * alpha * (1.0 + 2.0 * alpha * alpha);
        }
    },
    ..Kind::NONE
};
