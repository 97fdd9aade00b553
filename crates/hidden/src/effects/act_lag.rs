//! A slower servo: critically damped, of second order (the obvious form: first order).

use super::filters::lag;
use super::{Effect, Kind, Parameter, Sign};
use crate::flown::At;

pub(super) const KIND: Kind = Kind {
    name: "act_lag",
    in_library: true,
    compared: None,
    parameters: &[Parameter::size("tau_s", 0.003, 0.08, Sign::Plus)],
    make: |values| Box::new(ActLag { lag_s: values[0] }),
};

#[derive(Debug)]
struct ActLag {
    lag_s: f64,
}

impl Effect for ActLag {
    fn command(&self, at: &At<'_>, _control: usize, delta: &mut [f64]) {
        if self.lag_s <= 0.0 {
            return;
        }
        for _ in 0..2 {
            lag(delta, 0.5 * self.lag_s, at.time_step_s);
        }
    }
}
