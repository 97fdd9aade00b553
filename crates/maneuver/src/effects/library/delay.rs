//! The balance's readings come late, or early.

use crate::effects::prelude::*;

/// See the module.
pub(super) const FORMS: &[Declaration] = &[Declaration {
    spec: Spec {
        name: "delay",
        title: "time offset of the balance",
        side: Side::Sensor,
        rivals: &["daq_filter", "act_lag", "aero_lag"],
        experiment: "a common pulse; a tap without wind",
    },
    parameters: |_| vec![Parameter::new("tau_s", -0.06..=0.06, 0.02)],
    known: |known, parameters| parameters[0].know(Calibration::Clock, known.to.clock_s),
    stage: Stage::Record,
    loads: |p, place, _, loads| {
        if !place.steady && p[0] != 0.0 {
            for channel in &mut loads.balance {
                *channel = signal::delayed(channel, place.time_step_s, p[0]);
            }
        }
    },
    ..Declaration::NONE
}];
