//! A channel of the balance reads too much or too little, in proportion.

use super::prelude::*;

/// See the module.
#[derive(Debug)]
pub(crate) struct Gain;

impl Effect for Gain {
    fn spec(&self) -> &'static Spec {
        &Spec {
            name: "gain",
            title: "gain of a balance channel",
            side: Side::Balance,
            rivals: &["q_error", "crosstalk", "lift_slope", "balance_nonlin"],
            experiment: "dead weights",
        }
    }

    fn parameters(&self) -> Vec<Parameter> {
        vec![
            Parameter::new("g_fz", (-0.4, 0.4), 0.05),
            Parameter::new("g_mx", (-0.4, 0.4), 0.05),
            Parameter::new("g_my", (-0.4, 0.4), 0.05),
        ]
    }

    fn stage(&self) -> Stage {
        Stage::Reading
    }

    fn loads(&self, p: &[f64], _place: &Place<'_>, _seen: &Seen<'_>, loads: &mut Loads) {
        for (channel, gain) in loads.balance.iter_mut().zip(p) {
            for value in channel.iter_mut() {
                *value += gain * *value;
            }
        }
    }
}
