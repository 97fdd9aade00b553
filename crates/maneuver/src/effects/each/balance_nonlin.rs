//! A channel of the balance bends: `y += k y²`.

use super::prelude::*;

/// See the module.
#[derive(Debug)]
pub(crate) struct BalanceNonlin;

impl Effect for BalanceNonlin {
    fn spec(&self) -> &'static Spec {
        &Spec {
            name: "balance_nonlin",
            title: "quadratic response of a balance channel",
            side: Side::Balance,
            rivals: &["stall", "wall_correction"],
            experiment: "dead weights beyond the linear range",
        }
    }

    fn parameters(&self) -> Vec<Parameter> {
        vec![
            Parameter::new("k_fz_per_N", (-0.004, 0.004), 0.0005),
            Parameter::new("k_mx_per_Nm", (-0.004, 0.004), 0.0005),
            Parameter::new("k_my_per_Nm", (-0.01, 0.01), 0.0015),
        ]
    }

    fn stage(&self) -> Stage {
        Stage::Reading
    }

    fn loads(&self, p: &[f64], _place: &Place<'_>, _seen: &Seen<'_>, loads: &mut Loads) {
        for (channel, k) in loads.balance.iter_mut().zip(p) {
            for value in channel.iter_mut() {
                *value += k * *value * *value;
            }
        }
    }
}
