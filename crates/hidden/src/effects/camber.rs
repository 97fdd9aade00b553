//! Sections with another camber, more at the root than at the tip (the obvious form: the same everywhere).

use super::{Kind, Parameter, Sign};

pub(super) const KIND: Kind = Kind {
    name: "camber",
    parameters: &[
        Parameter::size("dcl0_deg", 0.03, 2.0, Sign::Either),
        Parameter::size("dcm0", 0.001, 0.03, Sign::Either),
    ],
    physics: |p, wing, _, physics| {
        let (angle_deg, moment) = (p[0], p[1]);
        for (strip, eta) in wing.strips.eta.iter().enumerate() {
            physics.incidence_rad[strip] += angle_deg.to_radians() * (1.1 - 0.25 * eta);
            physics.moment_offset[strip] += moment * (1.1 - 0.2 * eta);
        }
    },
    ..Kind::NONE
};
