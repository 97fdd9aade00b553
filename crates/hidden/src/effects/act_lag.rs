//! A slower servo: critically damped, of second order (the obvious form: first order).

use super::filters::lag;
use super::{Kind, Parameter, Sign};

pub(super) const KIND: Kind = Kind {
    name: "act_lag",
    parameters: &[Parameter::size("tau_s", 0.003, 0.08, Sign::Plus)],
    command: |p, at, _, delta| {
        if p[0] <= 0.0 {
            return;
        }
        for _ in 0..2 {
            lag(delta, 0.5 * p[0], at.time_step_s);
        }
    },
    ..Kind::NONE
};
