//! A channel of the balance reads too much or too little, in proportion.

use crate::effects::prelude::*;

/// See the module.
pub(super) const FORMS: &[Declaration] = &[Declaration {
    spec: Spec {
        name: "gain",
        title: "gain of a balance channel",
        side: Side::Balance,
        rivals: &["q_error", "crosstalk", "lift_slope", "balance_nonlin"],
        experiment: "dead weights",
    },
    parameters: |_| ["g_fz", "g_mx", "g_my"].map(|name| Parameter::new(name, -0.4..=0.4, 0.05)).to_vec(),
    stage: Stage::Reading,
    loads: |p, _, _, loads| loads.add_to_readings(p, |gain, _, y| gain * y),
    ..Declaration::NONE
}];
