//! The tunnel's walls turn the stream in proportion to lift: `alpha += delta_w S/C C_L`, delta_w S/C taken as one number.
//! The balance's Fz stands for lift: gravity's change and inertia are small beside it.

use crate::effects::prelude::*;

/// See the module.
pub(super) const FORMS: &[Declaration] = &[Declaration {
    spec: Spec {
        name: "wall_correction",
        title: "interference of the tunnel's walls",
        side: Side::Flow,
        rivals: &["lift_slope", "ac_shift", "q_error"],
        experiment: "two sizes of model, or wall pressures",
    },
    parameters: |_| vec![Parameter::new("delta_w_s_over_c_rad", -0.1..=0.1, 0.015)],
    change: |p, place, change| {
        let lift = place.q_pa() * place.zones.area_m2.iter().sum::<f64>();
        if lift > 0.0 {
            change.incidence_by_fz += p[0] / lift;
        }
    },
    ..Declaration::NONE
}];
