//! A wake that answers later, its slow part more than its fast part (the obvious form: one factor of all lags).

use super::{Effect, Kind, Parameter, Sign, WingView};
use crate::physics::Physics;

pub(super) const KIND: Kind = Kind {
    name: "aero_lag",
    in_library: true,
    compared: None,
    parameters: &[Parameter::size("dlag", 0.08, 3.0, Sign::Plus)],
    make: |values| Box::new(AeroLag { change: values[0] }),
};

#[derive(Debug)]
struct AeroLag {
    change: f64,
}

impl Effect for AeroLag {
    fn physics(&self, _wing: WingView<'_>, _v_m_s: f64, physics: &mut Physics) {
        for (place, rate) in physics.lag_rate.iter_mut().enumerate() {
            *rate /= 1.0 + self.change * (1.15 - 0.08 * place as f64);
        }
    }
}
