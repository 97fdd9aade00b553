//! The balance's amplifiers filter more than known: a low pass of two poles, or of four (two such filters one after the
//! other with twice the corner: the same delay at rest); the parameter is the inverse corner, so that zero is none.

use super::prelude::*;

/// See the module.
#[derive(Debug)]
pub(crate) struct DaqFilter {
    /// Filters of two poles, one after the other.
    pub(crate) pairs: u8,
}

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

    fn form(&self) -> &'static str {
        if self.pairs == 1 { "two poles" } else { "four poles" }
    }

    fn parameters(&self) -> Vec<Parameter> {
        vec![Parameter::new("inverse_corner_s", (0.0, 0.4), 0.05)]
    }

    fn stage(&self) -> Stage {
        Stage::Record
    }

    fn loads(&self, p: &[f64], place: &Place<'_>, _seen: &Seen<'_>, loads: &mut Loads) {
        if !place.steady && p[0] > 0.0 {
            for channel in &mut loads.balance {
                for _ in 0..self.pairs {
                    *channel = signal::second_order(channel, place.time_step_s, f64::from(self.pairs) / p[0]);
                }
            }
        }
    }
}
