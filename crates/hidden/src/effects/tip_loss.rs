//! A loss towards the tip with a power of its own (the obvious form: the square of the span).

use super::{Effect, Kind, Parameter, Sign, WingView};
use crate::physics::Physics;

pub(super) const KIND: Kind = Kind {
    name: "tip_loss",
    in_library: true,
    compared: None,
    parameters: &[Parameter::size("dt", 0.02, 0.7, Sign::Either)],
    make: |values| Box::new(TipLoss { loss: values[0] }),
};

#[derive(Debug)]
struct TipLoss {
    loss: f64,
}

impl Effect for TipLoss {
    fn physics(&self, wing: WingView<'_>, _v_m_s: f64, physics: &mut Physics) {
        for (lift, eta) in physics.lift.iter_mut().zip(&wing.strips.eta) {
            *lift *= 1.0 - self.loss * (0.45 * eta.powf(1.5) + 0.55 * eta.powi(3));
        }
    }
}
