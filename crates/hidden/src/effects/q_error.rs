//! A dynamic pressure that is wrong because the airspeed is, so that lags are too (the obvious form: a factor of
//! the loads).

use super::{Kind, Parameter, Sign};

pub(super) const KIND: Kind = Kind {
    name: "q_error",
    parameters: &[Parameter::size("eps", 0.004, 0.2, Sign::Either)],
    physics: |p, _, _, physics| {
        physics.airspeed *= (1.0 + p[0]).max(0.01).sqrt();
    },
    ..Kind::NONE
};
