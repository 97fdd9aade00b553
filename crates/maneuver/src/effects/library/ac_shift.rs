//! Lift acts further aft than a panel model has it.

use crate::effects::prelude::*;

/// See the module.
pub(super) const FORMS: &[Declaration] = &[Declaration {
    spec: Spec {
        name: "ac_shift",
        title: "aerodynamic centre of the sections",
        side: Side::Aerodynamics,
        rivals: &["crosstalk", "camber", "tors_stiff"],
        experiment: "dead weights for the balance's part; an airspeed sweep",
    },
    parameters: |_| vec![Parameter::new("dx_over_c", -0.1..=0.1, 0.02)],
    change: |p, _, change| change.zone_aft_over_c.iter_mut().for_each(|aft| *aft += p[0]),
    flight: Flight::Corrections,
    correct: |p, air| air.shift_aft(p[0]),
    ..Declaration::NONE
}];
