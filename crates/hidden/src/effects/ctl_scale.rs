//! Controls with less or more effect, not all alike (the obvious form: one factor).

use super::{Effect, Kind, Parameter, Sign, WingView};
use crate::physics::Physics;

pub(super) const KIND: Kind = Kind {
    name: "ctl_scale",
    in_library: true,
    compared: None,
    parameters: &[Parameter::size("deta", 0.01, 0.4, Sign::Either)],
    make: |values| Box::new(CtlScale { change: values[0] }),
};

#[derive(Debug)]
struct CtlScale {
    change: f64,
}

impl Effect for CtlScale {
    fn physics(&self, _wing: WingView<'_>, _v_m_s: f64, physics: &mut Physics) {
        for (control, flap) in physics.flap.iter_mut().enumerate() {
            *flap *= 1.0 + self.change * (1.06 - 0.06 * control as f64);
        }
    }
}
