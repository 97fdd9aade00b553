//! The balance's readings come late, or early.

use super::prelude::*;

/// See the module.
#[derive(Debug)]
pub(crate) struct Delay;

impl Effect for Delay {
    fn spec(&self) -> &'static Spec {
        &Spec {
            name: "delay",
            title: "time offset of the balance",
            side: Side::Sensor,
            rivals: &["daq_filter", "act_lag", "aero_lag"],
            experiment: "a common pulse; a tap without wind",
        }
    }

    fn parameters(&self) -> Vec<Parameter> {
        vec![Parameter::new("tau_s", (-0.06, 0.06), 0.02)]
    }

    fn stage(&self) -> Stage {
        Stage::Record
    }

    fn loads(&self, p: &[f64], place: &Place<'_>, _seen: &Seen<'_>, loads: &mut Loads) {
        if !place.steady && p[0] != 0.0 {
            for channel in &mut loads.balance {
                *channel = signal::delayed(channel, place.time_step_s, p[0]);
            }
        }
    }
}
