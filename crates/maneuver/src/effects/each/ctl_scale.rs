//! Control surfaces do more or less than modelled, in proportion (gap, hinge line).

use super::prelude::*;

/// See the module.
#[derive(Debug)]
pub(crate) struct CtlScale;

impl Effect for CtlScale {
    fn spec(&self) -> &'static Spec {
        &Spec {
            name: "ctl_scale",
            title: "effectiveness of the control surfaces",
            side: Side::Control,
            rivals: &["q_error", "ctl_compliance", "ctl_saturation"],
            experiment: "angle data, which it does not change",
        }
    }

    fn parameters(&self) -> Vec<Parameter> {
        vec![Parameter::new("deta", (-0.7, 0.7), 0.15)]
    }

    fn inputs(&self, p: &[f64], _place: &Place<'_>, inputs: &mut Inputs) {
        inputs.controls_rad.iter_mut().flatten().for_each(|delta| *delta += p[0] * *delta);
    }
}
