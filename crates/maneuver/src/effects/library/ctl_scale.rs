//! Control surfaces do more or less than modelled, in proportion (gap, hinge line).

use crate::effects::prelude::*;

/// See the module.
pub(super) const FORMS: &[Declaration] = &[Declaration {
    spec: Spec {
        name: "ctl_scale",
        title: "effectiveness of the control surfaces",
        side: Side::Control,
        rivals: &["q_error", "ctl_compliance", "ctl_saturation"],
        experiment: "angle data, which it does not change",
    },
    parameters: |_| vec![Parameter::new("deta", -0.7..=0.7, 0.15)],
    known: |known, parameters| parameters[0].know(Calibration::Surfaces, known.to.surfaces),
    inputs: |p, _, inputs| inputs.deflections().for_each(|delta| *delta += p[0] * *delta),
    excludes_deflection_correction: true,
    flight: Flight::Deflection,
    ..Declaration::NONE
}];
