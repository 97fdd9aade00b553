//! Torsional stiffness is off by a factor.

use crate::effects::prelude::*;

/// See the module.
pub(super) const FORMS: &[Declaration] = &[Declaration {
    spec: Spec {
        name: "tors_stiff",
        title: "torsional stiffness",
        side: Side::Structure,
        rivals: &["ac_shift", "ctl_compliance", "re_dependence"],
        experiment: "a chirp to 20 Hz; an airspeed sweep; a dead torque",
    },
    parameters: |_| vec![Parameter::new("dGJ", -0.7..=2.0, 0.25)],
    known: |known, parameters| parameters[0].know(Calibration::Stiffness, known.to.torsion),
    change: |p, _, change| change.torsion += p[0],
    splits_stiffness: true,
    ..Declaration::NONE
}];
