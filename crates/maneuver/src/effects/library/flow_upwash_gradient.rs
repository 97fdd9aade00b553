//! The stream's angle grows along the span.

use crate::effects::prelude::*;

/// See the module.
pub(super) const FORMS: &[Declaration] = &[Declaration {
    spec: Spec {
        name: "flow_upwash_gradient",
        title: "upwash of the stream grows along the span",
        side: Side::Flow,
        rivals: &["alpha_offset", "camber"],
        experiment: "a flow survey; an inverted run",
    },
    parameters: |_| vec![Parameter::new("a1_deg_per_m", -2.0..=2.0, 0.4)],
    constants: |p, _, constants| constants.upwash_rad_m += p[0].to_radians(),
    ..Declaration::NONE
}];
