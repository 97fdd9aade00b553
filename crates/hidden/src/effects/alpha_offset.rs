//! Flow that does not come along the tunnel's axis, a little more so outboard (the obvious form: a constant).

use super::{Kind, Parameter, Sign};

pub(super) const KIND: Kind = Kind {
    name: "alpha_offset",
    parameters: &[Parameter::size("a0_deg", 0.03, 2.0, Sign::Either)],
    physics: |p, wing, _, physics| {
        for (incidence, eta) in physics.incidence_rad.iter_mut().zip(&wing.strips.eta) {
            *incidence += p[0].to_radians() * (0.95 + 0.1 * eta);
        }
    },
    ..Kind::NONE
};
