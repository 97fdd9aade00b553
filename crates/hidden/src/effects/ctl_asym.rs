//! Deflections up have less effect than down, with a smooth change.

use super::{Effect, Kind, Parameter, Sign};
use crate::flown::At;

pub(super) const KIND: Kind = Kind {
    name: "ctl_asym",
    in_library: true,
    compared: None,
    parameters: &[Parameter::size("ka", 0.05, 0.4, Sign::Plus)],
    make: |values| Box::new(CtlAsym { loss: values[0] }),
};

/// Width of the change.
const WIDTH_RAD: f64 = 0.03;

#[derive(Debug)]
struct CtlAsym {
    loss: f64,
}

impl Effect for CtlAsym {
    fn deflection(&self, _at: &At<'_>, _control: usize, delta: &mut [f64]) {
        for value in delta {
            let up = 0.5 * (1.0 - (*value / WIDTH_RAD).tanh());
            *value *= 1.0 - self.loss * up;
        }
    }
}
