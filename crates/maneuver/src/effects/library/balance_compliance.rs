//! The balance or sting gives way: the root turns nose up under My, and the wing meets the air at another angle.
//! The parameter is the compliance 1/k_theta. Inertia of that turning is left out.

use crate::effects::prelude::*;

/// See the module.
pub(super) const FORMS: &[Declaration] = &[Declaration {
    spec: Spec {
        name: "balance_compliance",
        title: "the root turns under load",
        side: Side::Balance,
        rivals: &["lift_slope", "tors_stiff", "bend_stiff"],
        experiment: "the root's pose under load, by camera",
    },
    parameters: |_| vec![Parameter::new("compliance_rad_per_Nm", 0.0..=0.002, 0.0003)],
    change: |p, _, change| change.incidence_by_my += p[0],
    ..Declaration::NONE
}];
