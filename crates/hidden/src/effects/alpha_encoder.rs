//! An angle sensor with a wrong gain: the wing turns further than it says, with a sine (the obvious form: a factor).

use super::{Kind, Parameter, Sign};

pub(super) const KIND: Kind = Kind {
    name: "alpha_encoder",
    parameters: &[Parameter::size("g_a", 0.005, 0.1, Sign::Either)],
    reading: |p, alpha_deg| {
        if p[0] == 0.0 {
            return;
        }
        for angle in alpha_deg {
            *angle = (angle.to_radians().sin() / (1.0 + p[0])).asin().to_degrees();
        }
    },
    ..Kind::NONE
};
