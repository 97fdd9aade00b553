//! A loss of lift slope that waves along the span (the obvious form: the same everywhere); flaps keep theirs.

use super::{Effect, Kind, Parameter, Sign, WingView};
use crate::physics::Physics;

pub(super) const KIND: Kind = Kind {
    name: "lift_slope",
    in_library: true,
    compared: None,
    parameters: &[Parameter::size("dk", 0.008, 0.35, Sign::Either)],
    make: |values| Box::new(LiftSlope { change: values[0] }),
};

#[derive(Debug)]
struct LiftSlope {
    change: f64,
}

impl Effect for LiftSlope {
    fn physics(&self, wing: WingView<'_>, _v_m_s: f64, physics: &mut Physics) {
        if self.change == 0.0 {
            return;
        }
        for (lift, eta) in physics.lift.iter_mut().zip(&wing.strips.eta) {
            *lift *= 1.0 + self.change * (1.0 + 0.12 * (std::f64::consts::PI * eta).cos());
        }
        for flap in &mut physics.flap {
            *flap /= 1.0 + self.change;
        }
    }
}
