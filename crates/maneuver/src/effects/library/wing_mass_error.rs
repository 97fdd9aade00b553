//! The wing is heavier or lighter than modelled, in proportion everywhere.

use crate::effects::prelude::*;

/// See the module.
pub(super) const FORMS: &[Declaration] = &[Declaration {
    spec: Spec {
        name: "wing_mass_error",
        title: "mass of the wing off by a factor",
        side: Side::Structure,
        rivals: &["joiner_inertia", "tip_mass", "bend_stiff"],
        experiment: "weighing, and wind-off pitch",
    },
    parameters: |_| vec![Parameter::new("dm_over_m", -0.3..=0.3, 0.05)],
    known: |known, parameters| parameters[0].know(Calibration::Mass, known.to.mass),
    change: |p, _, change| change.mass += p[0],
    ..Declaration::NONE
}];
