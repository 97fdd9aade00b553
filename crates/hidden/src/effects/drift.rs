//! A zero that drifts as the balance warms up (the obvious form: linear in time).

use super::{Kind, Parameter, Sign};

pub(super) const KIND: Kind = Kind {
    name: "drift",
    compared: Some(|values| {
        let channel = super::chosen(values[1], 3);
        vec![(["d_fz_N_per_h", "d_mx_Nm_per_h", "d_my_Nm_per_h"][channel], SIZE[channel] * values[0])]
    }),
    parameters: &[Parameter::size("d_per_h", 0.1, 3.0, Sign::Either), Parameter::choice("channel", 3)],
    sensor: |p, at, flown| {
        let (per_h, channel) = (p[0], super::chosen(p[1], 3));
        for (i, load) in flown.loads[channel].iter_mut().enumerate() {
            let hours = (at.start_s + i as f64 * at.time_step_s) / 3600.0;
            *load += SIZE[channel] * per_h * WARM_H * (1.0 - (-hours / WARM_H).exp());
        }
    },
    ..Kind::NONE
};

/// Time constant of the warming, h.
const WARM_H: f64 = 3.0;
/// Of the channels, for a parameter in N/h: N, and N m.
const SIZE: [f64; 3] = [1.0, 0.6, 0.25];
