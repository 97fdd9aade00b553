//! A shift of the point where the lift acts, growing towards the tip (the obvious form: the same share of every chord).

use super::{Effect, Kind, Parameter, Sign, WingView};
use crate::physics::Physics;

pub(super) const KIND: Kind = Kind {
    name: "ac_shift",
    in_library: true,
    compared: None,
    parameters: &[Parameter::size("dx_over_c", 0.004, 0.05, Sign::Either)],
    make: |values| Box::new(AcShift { aft_over_c: values[0] }),
};

#[derive(Debug)]
struct AcShift {
    aft_over_c: f64,
}

impl Effect for AcShift {
    fn physics(&self, wing: WingView<'_>, _v_m_s: f64, physics: &mut Physics) {
        for (aft, eta) in physics.centre_aft_over_c.iter_mut().zip(&wing.strips.eta) {
            *aft += self.aft_over_c * (0.8 + 0.45 * eta);
        }
    }
}
