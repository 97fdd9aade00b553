//! Loads that are recorded late or early, not all channels alike (the obvious form: one time).

use super::filters::delayed;
use super::{Effect, Kind, Parameter, Sign};
use crate::flown::{At, Flown};

pub(super) const KIND: Kind = Kind {
    name: "delay",
    in_library: true,
    compared: None,
    parameters: &[Parameter::size("tau_s", 0.0015, 0.04, Sign::Either)],
    make: |values| Box::new(Delay { late_s: values[0] }),
};

#[derive(Debug)]
struct Delay {
    late_s: f64,
}

impl Effect for Delay {
    fn sensor(&self, at: &At<'_>, flown: &mut Flown) {
        if self.late_s == 0.0 {
            return;
        }
        for (load, share) in flown.loads.iter_mut().zip([0.95, 1.0, 1.05]) {
            *load = delayed(load, share * self.late_s / at.time_step_s);
        }
    }
}
