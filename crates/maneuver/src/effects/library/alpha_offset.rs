//! Flow angularity, or a zero of the angle that is off: the air sees another angle than gravity.

use crate::effects::prelude::*;

/// See the module.
pub(super) const FORMS: &[Declaration] = &[Declaration {
    spec: Spec {
        name: "alpha_offset",
        title: "zero of the angle of attack, or flow angularity",
        side: Side::Flow,
        rivals: &["camber", "flow_upwash_gradient", "drift"],
        experiment: "an inverted run",
    },
    parameters: |_| vec![Parameter::new("a0_deg", -3.0..=3.0, 0.5)],
    known: |known, parameters| parameters[0].know(Calibration::Angle, known.to.alpha_deg),
    inputs: |p, place, inputs| inputs.incline(place, p[0].to_radians()),
    ..Declaration::NONE
}];
