//! Upwash that grows along the span as a sine (the obvious form: linear).

use super::{Effect, Kind, Parameter, Sign, WingView};
use crate::physics::Physics;

pub(super) const KIND: Kind = Kind {
    name: "flow_upwash_gradient",
    in_library: true,
    compared: None,
    parameters: &[Parameter::size("a1_deg_per_m", 0.03, 1.5, Sign::Either)],
    make: |values| Box::new(FlowUpwashGradient { per_m: values[0] }),
};

#[derive(Debug)]
struct FlowUpwashGradient {
    per_m: f64,
}

impl Effect for FlowUpwashGradient {
    fn physics(&self, wing: WingView<'_>, _v_m_s: f64, physics: &mut Physics) {
        let strips = wing.strips;
        for (strip, incidence) in physics.incidence_rad.iter_mut().enumerate() {
            let rise = 1.1 * (0.9 * strips.eta[strip]).sin() / strips.eta[strip].max(1e-6);
            *incidence += (self.per_m * strips.y_m[strip]).to_radians() * rise;
        }
    }
}
