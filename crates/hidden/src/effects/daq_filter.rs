//! A low pass of four poles with the delay of the two poles that are stated (the obvious form: two poles).

use super::filters::butterworth_4;
use super::{Effect, Kind, Parameter, Sign};
use crate::flown::{At, Flown};

pub(super) const KIND: Kind = Kind {
    name: "daq_filter",
    in_library: true,
    compared: None,
    parameters: &[Parameter::size("inverse_corner_s", 0.01, 0.25, Sign::Plus)],
    make: |values| Box::new(DaqFilter { inverse_s: values[0] }),
};

/// Delays at rest are sqrt 2 / w for two poles and 2.613 / w for four.
const SAME_DELAY: f64 = 1.848;

#[derive(Debug)]
struct DaqFilter {
    inverse_s: f64,
}

impl Effect for DaqFilter {
    fn sensor(&self, at: &At<'_>, flown: &mut Flown) {
        if self.inverse_s <= 0.0 {
            return;
        }
        for load in &mut flown.loads {
            butterworth_4(load, SAME_DELAY / self.inverse_s, at.time_step_s);
        }
    }
}
