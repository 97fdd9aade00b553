//! A servo that cannot move faster than a rate, with a soft knee (the obvious form: a sharp limit).

use super::{Kind, Parameter, Sign};

pub(super) const KIND: Kind = Kind {
    name: "act_rate",
    parameters: &[Parameter::size("inverse_rate_s_per_rad", 0.05, 1.0, Sign::Plus)],
    command: |p, at, _, delta| {
        let Some(&first) = delta.first() else { return };
        if p[0] <= 0.0 {
            return;
        }
        let most = at.time_step_s / p[0];
        let mut place = first;
        for value in delta {
            let wanted = (*value - place) / most;
            // x / (1 + x⁶)^(1/6): one beyond one, x below
            place += most * wanted / (1.0 + wanted.powi(6)).powf(1.0 / 6.0);
            *value = place;
        }
    },
    ..Kind::NONE
};
