//! A balance that bends with the load: a rational curve (the obvious form: a square).

use super::{Kind, Parameter, Sign};

pub(super) const KIND: Kind = Kind {
    name: "balance_nonlin",
    compared: Some(|values| {
        let channel = super::chosen(values[1], 3);
        vec![(["k_fz_per_N", "k_mx_per_Nm", "k_my_per_Nm"][channel], values[0] / RANGE[channel])]
    }),
    parameters: &[Parameter::size("k2_over_range", 0.01, 0.2, Sign::Either), Parameter::choice("channel", 3)],
    sensor: |p, _, flown| {
        let (bend, channel) = (p[0], super::chosen(p[1], 3));
        for load in &mut flown.loads[channel] {
            let share = *load / RANGE[channel];
            *load *= 1.0 + bend * share / (1.0 + 0.3 * share.abs());
        }
    },
    ..Kind::NONE
};

/// Ranges of the channels, N and N m.
const RANGE: [f64; 3] = [300.0, 200.0, 100.0];
