//! A wake that answers later, its slow part more than its fast part (the obvious form: one factor of all lags). A
//! second value, which the benchmark does not draw, makes all that is unsteady larger or smaller.

use super::{Kind, Parameter, Sign};

pub(super) const KIND: Kind = Kind {
    name: "aero_lag",
    parameters: &[Parameter::size("dlag", 0.08, 3.0, Sign::Plus)],
    physics: |p, _, _, physics| {
        for (place, rate) in physics.lag_rate.iter_mut().enumerate() {
            *rate /= 1.0 + p[0] * (1.15 - 0.08 * place as f64);
        }
        physics.unsteady += p.get(1).copied().unwrap_or(0.0);
    },
    ..Kind::NONE
};
