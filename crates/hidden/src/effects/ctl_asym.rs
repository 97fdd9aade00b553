//! Deflections up have less effect than down, with a smooth change.

use super::{Kind, Parameter, Sign};

pub(super) const KIND: Kind = Kind {
    name: "ctl_asym",
    parameters: &[Parameter::size("ka", 0.05, 0.4, Sign::Plus)],
    deflection: |p, _, _, delta| {
        for value in delta {
            let up = 0.5 * (1.0 - (*value / WIDTH_RAD).tanh());
            *value *= 1.0 - p[0] * up;
        }
    },
    ..Kind::NONE
};

/// Width of the change.
const WIDTH_RAD: f64 = 0.03;
