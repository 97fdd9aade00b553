//! A servo that cannot move faster than a rate, with a soft knee (the obvious form: a sharp limit).

use super::{Effect, Kind, Parameter, Sign};
use crate::flown::At;

pub(super) const KIND: Kind = Kind {
    name: "act_rate",
    in_library: true,
    compared: None,
    parameters: &[Parameter::size("inverse_rate_s_per_rad", 0.05, 1.0, Sign::Plus)],
    make: |values| Box::new(ActRate { inverse: values[0] }),
};

#[derive(Debug)]
struct ActRate {
    inverse: f64,
}

impl Effect for ActRate {
    fn command(&self, at: &At<'_>, _control: usize, delta: &mut [f64]) {
        let Some(&first) = delta.first() else { return };
        if self.inverse <= 0.0 {
            return;
        }
        let most = at.time_step_s / self.inverse;
        let mut place = first;
        for value in delta {
            let wanted = (*value - place) / most;
            // x / (1 + x⁶)^(1/6): one beyond one, x below
            place += most * wanted / (1.0 + wanted.powi(6)).powf(1.0 / 6.0);
            *value = place;
        }
    }
}
