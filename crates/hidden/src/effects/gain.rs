//! A channel with a wrong slope that bends a little with the load (the obvious form: a factor).

use super::{Effect, Kind, Parameter, Sign};
use crate::flown::{At, Flown};

pub(super) const KIND: Kind = Kind {
    name: "gain",
    in_library: true,
    compared: Some(|values| vec![(["g_fz", "g_mx", "g_my"][super::chosen(values[1], 3)], values[0])]),
    parameters: &[Parameter::size("g", 0.004, 0.2, Sign::Either), Parameter::choice("channel", 3)],
    make: |values| Box::new(Gain { gain: values[0], channel: super::chosen(values[1], 3) }),
};

/// Ranges of the channels, N and N m.
const RANGE: [f64; 3] = [300.0, 200.0, 100.0];

#[derive(Debug)]
struct Gain {
    gain: f64,
    channel: usize,
}

impl Effect for Gain {
    fn sensor(&self, _at: &At<'_>, flown: &mut Flown) {
        for load in &mut flown.loads[self.channel] {
            let share = (*load / RANGE[self.channel]).tanh();
            *load *= 1.0 + self.gain * (1.05 - 0.15 * share * share);
        }
    }
}
