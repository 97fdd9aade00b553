//! A rolling moment with the square of the angle of attack, which no library has.

use super::{Kind, Parameter, Sign};

pub(super) const KIND: Kind = Kind {
    name: "mx_alpha_squared",
    in_library: false,
    parameters: &[Parameter::size("k_m3", 0.05, 0.8, Sign::Either)],
    balance: |p, at, flown| {
        for (mx, alpha) in flown.loads[1].iter_mut().zip(at.alpha_rad) {
            *mx += p[0] * at.q_pa * alpha * alpha;
        }
    },
    ..Kind::NONE
};
