//! Control surfaces do more one way than the other.

use super::prelude::*;

/// See the module.
#[derive(Debug)]
pub(crate) struct CtlAsym;

impl Effect for CtlAsym {
    fn spec(&self) -> &'static Spec {
        &Spec {
            name: "ctl_asym",
            title: "up and down deflections differ",
            side: Side::Control,
            rivals: &["camber", "ctl_saturation"],
            experiment: "a static sweep of the flap, both ways",
        }
    }

    fn parameters(&self) -> Vec<Parameter> {
        vec![Parameter::new("ka", (-0.6, 0.6), 0.1)]
    }

    fn inputs(&self, p: &[f64], _place: &Place<'_>, inputs: &mut Inputs) {
        for delta in inputs.controls_rad.iter_mut().flatten() {
            if *delta > 0.0 {
                *delta *= 1.0 - p[0];
            }
        }
    }
}
