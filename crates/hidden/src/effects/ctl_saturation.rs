//! Deflections that lose effect as they grow: a rational function with the cubic term of the hyperbolic tangent
//! (the obvious form).

use super::{Kind, Parameter, Sign};

pub(super) const KIND: Kind = Kind {
    name: "ctl_saturation",
    compared: Some(|values| {
        let names = ["inverse_s_inner_per_rad", "inverse_s_middle_per_rad", "inverse_s_outer_per_rad"];
        names.into_iter().enumerate().map(|(control, name)| (name, values[0] * share(control))).collect()
    }),
    parameters: &[Parameter::size("inverse_s_per_rad", 0.4, 5.0, Sign::Plus)],
    deflection: |p, _, control, delta| {
        let inverse = p[0] * share(control);
        for value in delta {
            *value /= 1.0 + (inverse * *value).powi(2) / 3.0;
        }
    },
    ..Kind::NONE
};

/// Controls further out lose more.
fn share(control: usize) -> f64 {
    0.92 + 0.08 * control as f64
}
