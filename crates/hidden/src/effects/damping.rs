//! Another structural damping, less so for fast modes (the obvious form: one factor).

use super::{Kind, Parameter, Sign};

pub(super) const KIND: Kind = Kind {
    name: "damping",
    parameters: &[Parameter::size("dz", 0.2, 5.0, Sign::Plus)],
    physics: |p, wing, _, physics| {
        for (zeta, omega) in physics.damping.iter_mut().zip(wing.omega_rad_s) {
            *zeta *= 1.0 + p[0] * (wing.omega_rad_s[0] / omega).powf(0.25);
        }
    },
    ..Kind::NONE
};
