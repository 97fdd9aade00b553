//! Deflections that lose effect with the angle of attack: a logistic curve (the obvious form: linear).

use super::{Effect, Kind, Parameter, Sign};
use crate::flown::At;

pub(super) const KIND: Kind = Kind {
    name: "ctl_alpha_interaction",
    in_library: true,
    compared: None,
    parameters: &[Parameter::size("kda_per_rad", 0.5, 5.0, Sign::Either)],
    make: |values| Box::new(CtlAlphaInteraction { per_rad: values[0] }),
};

#[derive(Debug)]
struct CtlAlphaInteraction {
    per_rad: f64,
}

impl Effect for CtlAlphaInteraction {
    fn deflection(&self, at: &At<'_>, _control: usize, delta: &mut [f64]) {
        for (value, alpha) in delta.iter_mut().zip(at.alpha_rad) {
            *value *= 2.0 / (1.0 + (2.0 * self.per_rad * alpha).exp());
        }
    }
}
