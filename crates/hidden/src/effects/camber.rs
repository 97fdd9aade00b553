//! Sections with another camber, more at the root than at the tip (the obvious form: the same everywhere).

use super::{Effect, Kind, Parameter, Sign, WingView};
use crate::physics::Physics;

pub(super) const KIND: Kind = Kind {
    name: "camber",
    in_library: true,
    compared: None,
    parameters: &[
        Parameter::size("dcl0_deg", 0.03, 2.0, Sign::Either),
        Parameter::size("dcm0", 0.001, 0.03, Sign::Either),
    ],
    make: |values| Box::new(Camber { angle_deg: values[0], moment: values[1] }),
};

#[derive(Debug)]
struct Camber {
    angle_deg: f64,
    moment: f64,
}

impl Effect for Camber {
    fn physics(&self, wing: WingView<'_>, _v_m_s: f64, physics: &mut Physics) {
        for (strip, eta) in wing.strips.eta.iter().enumerate() {
            physics.incidence_rad[strip] += self.angle_deg.to_radians() * (1.1 - 0.25 * eta);
            physics.moment_offset[strip] += self.moment * (1.1 - 0.2 * eta);
        }
    }
}
