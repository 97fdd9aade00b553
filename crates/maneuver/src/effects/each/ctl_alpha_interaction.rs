//! Control surfaces do less at angle of attack.

use super::prelude::*;

/// See the module.
#[derive(Debug)]
pub(crate) struct CtlAlphaInteraction;

impl Effect for CtlAlphaInteraction {
    fn spec(&self) -> &'static Spec {
        &Spec {
            name: "ctl_alpha_interaction",
            title: "effectiveness falls with angle of attack",
            side: Side::Control,
            rivals: &["stall", "ctl_scale"],
            experiment: "angles and deflections in a factorial",
        }
    }

    fn parameters(&self) -> Vec<Parameter> {
        vec![Parameter::new("kda_per_rad", (-6.0, 6.0), 1.0)]
    }

    fn inputs(&self, p: &[f64], _place: &Place<'_>, inputs: &mut Inputs) {
        for control in &mut inputs.controls_rad {
            for (delta, alpha) in control.iter_mut().zip(&inputs.alpha.value) {
                *delta *= (1.0 - p[0] * alpha).max(0.0);
            }
        }
    }
}
