//! A channel of the balance bends: `y += k y²`, or (`by sign`) has another slope pulled than pushed: `y += k |y|`, as bridges
//! with a joint that opens have.

use crate::effects::prelude::*;

/// See the module.
pub(super) const FORMS: &[Declaration] = &[
    SQUARE,
    Declaration {
        form: "by sign",
        parameters: |_| ["k_fz", "k_mx", "k_my"].map(|k| Parameter::new(k, -0.2..=0.2, 0.02)).to_vec(),
        loads: |p, _, _, loads| loads.add_to_readings(p, |k, _, y| k * y.abs()),
        ..SQUARE
    },
];

const SQUARE: Declaration = Declaration {
    spec: Spec {
        name: "balance_nonlin",
        title: "a balance channel is not linear",
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
};
