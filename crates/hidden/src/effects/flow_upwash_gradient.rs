//! Upwash that grows along the span as a sine (the obvious form: linear).

use super::{Kind, Parameter, Sign};

pub(super) const KIND: Kind = Kind {
    name: "flow_upwash_gradient",
    parameters: &[Parameter::size("a1_deg_per_m", 0.03, 1.5, Sign::Either)],
    physics: |p, wing, _, physics| {
        let strips = wing.strips;
        for (strip, incidence) in physics.incidence_rad.iter_mut().enumerate() {
            let rise = 1.1 * (0.9 * strips.eta[strip]).sin() / strips.eta[strip].max(1e-6);
            *incidence += (p[0] * strips.y_m[strip]).to_radians() * rise;
        }
    },
    ..Kind::NONE
};
