//! A balance that bends with the load: a rational curve (the obvious form: a square).

use super::{Effect, Kind, Parameter, Sign};
use crate::flown::{At, Flown};

pub(super) const KIND: Kind = Kind {
    name: "balance_nonlin",
    in_library: true,
    compared: Some(|values| {
        let channel = super::chosen(values[1], 3);
        vec![(["k_fz_per_N", "k_mx_per_Nm", "k_my_per_Nm"][channel], values[0] / RANGE[channel])]
    }),
    parameters: &[Parameter::size("k2_over_range", 0.01, 0.2, Sign::Either), Parameter::choice("channel", 3)],
    make: |values| Box::new(BalanceNonlin { bend: values[0], channel: super::chosen(values[1], 3) }),
};

/// Ranges of the channels, N and N m.
const RANGE: [f64; 3] = [300.0, 200.0, 100.0];

#[derive(Debug)]
struct BalanceNonlin {
    bend: f64,
    channel: usize,
}

impl Effect for BalanceNonlin {
    fn sensor(&self, _at: &At<'_>, flown: &mut Flown) {
        for load in &mut flown.loads[self.channel] {
            let share = *load / RANGE[self.channel];
            *load *= 1.0 + self.bend * share / (1.0 + 0.3 * share.abs());
        }
    }
}
