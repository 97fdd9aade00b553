//! Structural damping is off by a factor.

use crate::effects::prelude::*;

/// See the module.
pub(super) const FORMS: &[Declaration] = &[Declaration {
    spec: Spec {
        name: "damping",
        title: "structural damping",
        side: Side::Structure,
        rivals: &["aero_lag", "lift_slope"],
        experiment: "a free decay without wind",
    },
    parameters: |_| vec![Parameter::new("dz", -0.9..=6.0, 1.0)],
    known: |known, parameters| parameters[0].know(Calibration::Damping, known.to.damping),
    change: |p, _, change| change.damping += p[0],
    ..Declaration::NONE
}];
