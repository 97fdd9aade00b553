//! Loads that are recorded late or early, not all channels alike (the obvious form: one time).

use super::filters::delayed;
use super::{Kind, Parameter, Sign};

pub(super) const KIND: Kind = Kind {
    name: "delay",
    parameters: &[Parameter::size("tau_s", 0.0015, 0.04, Sign::Either)],
    sensor: |p, at, flown| {
        if p[0] == 0.0 {
            return;
        }
        for (load, share) in flown.loads.iter_mut().zip([0.95, 1.0, 1.05]) {
            *load = delayed(load, share * p[0] / at.time_step_s);
        }
    },
    ..Kind::NONE
};
