//! Flow that does not come along the tunnel's axis, a little more so outboard (the obvious form: a constant).

use super::{Effect, Kind, Parameter, Sign, WingView};
use crate::physics::Physics;

pub(super) const KIND: Kind = Kind {
    name: "alpha_offset",
    in_library: true,
    compared: None,
    parameters: &[Parameter::size("a0_deg", 0.03, 2.0, Sign::Either)],
    make: |values| Box::new(AlphaOffset { angle_deg: values[0] }),
};

#[derive(Debug)]
struct AlphaOffset {
    angle_deg: f64,
}

impl Effect for AlphaOffset {
    fn physics(&self, wing: WingView<'_>, _v_m_s: f64, physics: &mut Physics) {
        for (incidence, eta) in physics.incidence_rad.iter_mut().zip(&wing.strips.eta) {
            *incidence += self.angle_deg.to_radians() * (0.95 + 0.1 * eta);
        }
    }
}
