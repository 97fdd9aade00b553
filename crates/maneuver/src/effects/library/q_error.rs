//! Dynamic pressure is not what the tunnel says (blockage, a pitot tube): all loads of the air are off alike.

use crate::effects::prelude::*;

/// See the module.
pub(super) const FORMS: &[Declaration] = &[Declaration {
    spec: Spec {
        name: "q_error",
        title: "error of dynamic pressure",
        side: Side::Flow,
        rivals: &["lift_slope", "tip_loss", "ctl_scale", "gain"],
        experiment: "a pitot survey; compare offsets, slopes and flap loads",
    },
    parameters: |_| vec![Parameter::new("eps", -0.3..=0.3, 0.05)],
    change: |p, _, change| change.pressure += p[0],
    ..Declaration::NONE
}];
