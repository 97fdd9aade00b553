//! Bending stiffness is off by a factor.

use crate::effects::prelude::*;

/// See the module.
pub(super) const FORMS: &[Declaration] = &[Declaration {
    spec: Spec {
        name: "bend_stiff",
        title: "bending stiffness",
        side: Side::Structure,
        rivals: &["tip_mass", "tip_loss", "wing_mass_error"],
        experiment: "a dead weight at the tip; wind-off pitch",
    },
    parameters: |_| vec![Parameter::new("dEI", -0.6..=1.0, 0.15)],
    known: |known, parameters| parameters[0].know(Calibration::Stiffness, known.to.bending),
    change: |p, _, change| change.bending += p[0],
    splits_stiffness: true,
    ..Declaration::NONE
}];
