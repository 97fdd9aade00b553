//! A channel with a wrong slope that bends a little with the load (the obvious form: a factor).

use super::{Kind, Parameter, Sign};

pub(super) const KIND: Kind = Kind {
    name: "gain",
    compared: Some(|values| vec![(["g_fz", "g_mx", "g_my"][super::chosen(values[1], 3)], values[0])]),
    parameters: &[Parameter::size("g", 0.004, 0.2, Sign::Either), Parameter::choice("channel", 3)],
    sensor: |p, _, flown| {
        let (gain, channel) = (p[0], super::chosen(p[1], 3));
        for load in &mut flown.loads[channel] {
            let share = (*load / RANGE[channel]).tanh();
            *load *= 1.0 + gain * (1.05 - 0.15 * share * share);
        }
    },
    ..Kind::NONE
};

/// Ranges of the channels, N and N m.
const RANGE: [f64; 3] = [300.0, 200.0, 100.0];
