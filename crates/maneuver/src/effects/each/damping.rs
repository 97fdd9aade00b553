//! Structural damping is off by a factor.

use super::prelude::*;

/// See the module.
#[derive(Debug)]
pub(crate) struct Damping;

impl Effect for Damping {
    fn spec(&self) -> &'static Spec {
        &Spec {
            name: "damping",
            title: "structural damping",
            side: Side::Structure,
            rivals: &["aero_lag", "lift_slope"],
            experiment: "a free decay without wind",
        }
    }

    fn parameters(&self) -> Vec<Parameter> {
        vec![Parameter::new("dz", (-0.9, 6.0), 1.0)]
    }

    fn change(&self, p: &[f64], _place: &Place<'_>, change: &mut Change) {
        change.damping += p[0];
    }
}
