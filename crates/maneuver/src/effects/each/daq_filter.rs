//! The balance's amplifiers filter more than known: a low pass of second order; the parameter is the inverse corner, so
//! that zero is none.

use super::prelude::*;

/// See the module.
#[derive(Debug)]
pub(crate) struct DaqFilter;

impl Effect for DaqFilter {
    fn spec(&self) -> &'static Spec {
        &Spec {
            name: "daq_filter",
            title: "low pass of the balance's amplifiers",
            side: Side::Sensor,
            rivals: &["delay", "act_lag"],
            experiment: "a chirp to 20 Hz",
        }
    }

    fn parameters(&self) -> Vec<Parameter> {
        vec![Parameter::new("inverse_corner_s", (0.0, 0.4), 0.05)]
    }

    fn loads(&self, p: &[f64], place: &Place<'_>, _seen: &Seen<'_>, loads: &mut Loads) {
        if !place.steady && p[0] > 0.0 {
            for channel in &mut loads.balance {
                *channel = signal::second_order(channel, place.time_step_s, 1.0 / p[0]);
            }
        }
    }
}
