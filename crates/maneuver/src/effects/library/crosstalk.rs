//! Balance interaction: the balance's channels read a share of each other, or its axes are not aligned.
//! `y += C y`, C without diagonal.

use crate::effects::prelude::*;

/// See the module.
pub(super) const FORMS: &[Declaration] = &[Declaration {
    spec: Spec {
        name: "crosstalk",
        title: "balance interaction: channels read a share of each other",
        side: Side::Balance,
        rivals: &["ac_shift", "gain", "joiner_inertia", "balance_nonlin"],
        experiment: "dead weights at several stations, wind off",
    },
    parameters: |_| {
        ["c_fz_mx_per_m", "c_fz_my_per_m", "c_mx_fz_m", "c_mx_my", "c_my_fz_m", "c_my_mx"]
            .map(|name| Parameter::new(name, -0.2..=0.2, 0.02))
            .to_vec()
    },
    stage: Stage::Reading,
    loads: |p, _, state, loads| {
        for i in 0..state.len() {
            let [fz, mx, my] = [0, 1, 2].map(|c| loads.balance[c][i]);
            loads.balance[0][i] += p[0] * mx + p[1] * my;
            loads.balance[1][i] += p[2] * fz + p[3] * my;
            loads.balance[2][i] += p[4] * fz + p[5] * mx;
        }
    },
    ..Declaration::NONE
}];
