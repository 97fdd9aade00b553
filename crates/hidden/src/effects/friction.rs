//! A bearing's friction that turns with the rate (the obvious form: jumps with its sign).

use super::{Kind, Parameter, Sign};

pub(super) const KIND: Kind = Kind {
    name: "friction",
    parameters: &[Parameter::size("c_Nm", 0.02, 1.5, Sign::Minus)],
    balance: |p, at, flown| {
        for (my, rate) in flown.loads[2].iter_mut().zip(at.alpha_rate) {
            *my += p[0] * (rate / RATE_RAD_S).tanh();
        }
    },
    ..Kind::NONE
};

/// Rate at which three quarters of the friction are there.
const RATE_RAD_S: f64 = 0.02;
