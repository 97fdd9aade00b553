//! A bearing's friction that turns with the rate (the obvious form: jumps with its sign).

use super::{Effect, Kind, Parameter, Sign};
use crate::flown::{At, Flown};

pub(super) const KIND: Kind = Kind {
    name: "friction",
    in_library: true,
    compared: None,
    parameters: &[Parameter::size("c_Nm", 0.02, 1.5, Sign::Minus)],
    make: |values| Box::new(Friction { torque_nm: values[0] }),
};

/// Rate at which three quarters of the friction are there.
const RATE_RAD_S: f64 = 0.02;

#[derive(Debug)]
struct Friction {
    torque_nm: f64,
}

impl Effect for Friction {
    fn balance(&self, at: &At<'_>, flown: &mut Flown) {
        for (my, rate) in flown.loads[2].iter_mut().zip(at.alpha_rate) {
            *my += self.torque_nm * (rate / RATE_RAD_S).tanh();
        }
    }
}
