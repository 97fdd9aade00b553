//! A low pass of four poles with the delay of the two poles that are stated (the obvious form: two poles).

use super::filters::butterworth_4;
use super::{Kind, Parameter, Sign};

pub(super) const KIND: Kind = Kind {
    name: "daq_filter",
    parameters: &[Parameter::size("inverse_corner_s", 0.01, 0.25, Sign::Plus)],
    sensor: |p, at, flown| {
        if p[0] <= 0.0 {
            return;
        }
        for load in &mut flown.loads {
            butterworth_4(load, SAME_DELAY / p[0], at.time_step_s);
        }
    },
    ..Kind::NONE
};

/// Delays at rest are sqrt 2 / w for two poles and 2.613 / w for four.
const SAME_DELAY: f64 = 1.848;
