//! Zeros of the balance drift with the clock.

use super::prelude::*;

/// See the module.
#[derive(Debug)]
pub(crate) struct Drift;

impl Effect for Drift {
    fn spec(&self) -> &'static Spec {
        &Spec {
            name: "drift",
            title: "zeros of the balance drift over the campaign",
            side: Side::Balance,
            rivals: &["alpha_offset", "camber"],
            experiment: "zeros without wind before and after each run; runs in random order",
        }
    }

    fn parameters(&self) -> Vec<Parameter> {
        vec![
            Parameter::new("d_fz_N_per_h", (-5.0, 5.0), 0.5),
            Parameter::new("d_mx_Nm_per_h", (-4.0, 4.0), 0.4),
            Parameter::new("d_my_Nm_per_h", (-2.0, 2.0), 0.2),
        ]
    }

    fn stage(&self) -> Stage {
        Stage::Reading
    }

    fn loads(&self, p: &[f64], place: &Place<'_>, seen: &Seen<'_>, loads: &mut Loads) {
        if place.steady {
            return;
        }
        for (channel, rate) in loads.balance.iter_mut().zip(p) {
            for (i, value) in channel.iter_mut().enumerate().take(seen.len()) {
                *value += rate * (place.clock_h + i as f64 * place.time_step_s / 3600.0);
            }
        }
    }
}
