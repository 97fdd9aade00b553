//! Deflections that lose effect as they grow: a rational function with the cubic term of the hyperbolic tangent
//! (the obvious form).

use super::{Effect, Kind, Parameter, Sign};
use crate::flown::At;

pub(super) const KIND: Kind = Kind {
    name: "ctl_saturation",
    in_library: true,
    compared: Some(|values| {
        let names = ["inverse_s_inner_per_rad", "inverse_s_middle_per_rad", "inverse_s_outer_per_rad"];
        names.into_iter().enumerate().map(|(control, name)| (name, values[0] * share(control))).collect()
    }),
    parameters: &[Parameter::size("inverse_s_per_rad", 0.4, 5.0, Sign::Plus)],
    make: |values| Box::new(CtlSaturation { inverse: values[0] }),
};

/// Controls further out lose more.
fn share(control: usize) -> f64 {
    0.92 + 0.08 * control as f64
}

#[derive(Debug)]
struct CtlSaturation {
    inverse: f64,
}

impl Effect for CtlSaturation {
    fn deflection(&self, _at: &At<'_>, control: usize, delta: &mut [f64]) {
        let inverse = self.inverse * share(control);
        for value in delta {
            *value /= 1.0 + (inverse * *value).powi(2) / 3.0;
        }
    }
}
