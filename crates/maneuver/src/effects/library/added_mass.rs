//! Apparent mass of the air is off by a factor.

use crate::effects::prelude::*;

/// See the module.
pub(super) const FORMS: &[Declaration] = &[Declaration {
    spec: Spec {
        name: "added_mass",
        title: "apparent mass of the air",
        side: Side::Aerodynamics,
        rivals: &["joiner_inertia", "wing_mass_error"],
        experiment: "runs in air beside the weighed inertia; it does not depend on airspeed",
    },
    parameters: |_| vec![Parameter::new("dam", -0.95..=4.0, 0.5)],
    known: |known, parameters| parameters[0].know(Calibration::Air, known.to.apparent_mass),
    change: |p, _, change| change.apparent_mass += p[0],
    ..Declaration::NONE
}];
