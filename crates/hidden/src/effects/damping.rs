//! Another structural damping, less so for fast modes (the obvious form: one factor).

use super::{Effect, Kind, Parameter, Sign, WingView};
use crate::physics::Physics;

pub(super) const KIND: Kind = Kind {
    name: "damping",
    in_library: true,
    compared: None,
    parameters: &[Parameter::size("dz", 0.2, 5.0, Sign::Plus)],
    make: |values| Box::new(Damping { change: values[0] }),
};

#[derive(Debug)]
struct Damping {
    change: f64,
}

impl Effect for Damping {
    fn physics(&self, wing: WingView<'_>, _v_m_s: f64, physics: &mut Physics) {
        for (zeta, omega) in physics.damping.iter_mut().zip(wing.omega_rad_s) {
            *zeta *= 1.0 + self.change * (wing.omega_rad_s[0] / omega).powf(0.25);
        }
    }
}
