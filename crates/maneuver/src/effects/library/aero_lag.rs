//! The wake remembers longer or shorter than the doublet lattice says.

use crate::effects::prelude::*;

/// See the module.
pub(super) const FORMS: &[Declaration] = &[Declaration {
    spec: Spec {
        name: "aero_lag",
        title: "lag of the wake",
        side: Side::Aerodynamics,
        rivals: &["delay", "act_lag", "added_mass"],
        experiment: "a frequency sweep at two airspeeds: it collapses on reduced frequency",
    },
    parameters: |_| vec![Parameter::new("dlag", -0.8..=5.0, 0.5)],
    known: |known, parameters| parameters[0].know(Calibration::Air, known.to.wake_lag),
    change: |p, _, change| change.lag += p[0],
    ..Declaration::NONE
}];
