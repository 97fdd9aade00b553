//! A dynamic pressure that is wrong because the airspeed is, so that lags are too (the obvious form: a factor of
//! the loads).

use super::{Effect, Kind, Parameter, Sign, WingView};
use crate::physics::Physics;

pub(super) const KIND: Kind = Kind {
    name: "q_error",
    in_library: true,
    compared: None,
    parameters: &[Parameter::size("eps", 0.004, 0.2, Sign::Either)],
    make: |values| Box::new(QError { share: values[0] }),
};

#[derive(Debug)]
struct QError {
    share: f64,
}

impl Effect for QError {
    fn physics(&self, _wing: WingView<'_>, _v_m_s: f64, physics: &mut Physics) {
        physics.airspeed *= (1.0 + self.share).max(0.01).sqrt();
    }
}
