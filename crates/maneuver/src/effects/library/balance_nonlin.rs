//! A channel of the balance bends: `y += k y²`.

use crate::effects::prelude::*;

/// See the module.
pub(super) const FORMS: &[Declaration] = &[Declaration {
    spec: Spec {
        name: "balance_nonlin",
        title: "quadratic response of a balance channel",
        side: Side::Balance,
        rivals: &["stall", "wall_correction"],
        experiment: "dead weights beyond the linear range",
    },
    parameters: |_| {
        vec![
            Parameter::new("k_fz_per_N", -0.004..=0.004, 0.0005),
            Parameter::new("k_mx_per_Nm", -0.004..=0.004, 0.0005),
            Parameter::new("k_my_per_Nm", -0.01..=0.01, 0.0015),
        ]
    },
    stage: Stage::Reading,
    loads: |p, _, _, loads| loads.add_to_readings(p, |k, _, y| k * y * y),
    ..Declaration::NONE
}];
