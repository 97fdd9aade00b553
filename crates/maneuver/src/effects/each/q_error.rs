//! Dynamic pressure is not what the tunnel says (blockage, a pitot tube): all loads of the air are off alike.

use super::prelude::*;

/// See the module.
#[derive(Debug)]
pub(crate) struct QError;

impl Effect for QError {
    fn spec(&self) -> &'static Spec {
        &Spec {
            name: "q_error",
            title: "error of dynamic pressure",
            side: Side::Flow,
            rivals: &["lift_slope", "tip_loss", "ctl_scale", "gain"],
            experiment: "a pitot survey; compare offsets, slopes and flap loads",
        }
    }

    fn parameters(&self) -> Vec<Parameter> {
        vec![Parameter::new("eps", (-0.3, 0.3), 0.05)]
    }

    fn change(&self, p: &[f64], _place: &Place<'_>, change: &mut Change) {
        change.pressure += p[0];
    }
}
