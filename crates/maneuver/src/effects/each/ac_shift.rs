//! Lift acts further aft than a panel model has it.

use super::prelude::*;

/// See the module.
#[derive(Debug)]
pub(crate) struct AcShift;

impl Effect for AcShift {
    fn spec(&self) -> &'static Spec {
        &Spec {
            name: "ac_shift",
            title: "aerodynamic centre of the sections",
            side: Side::Aerodynamics,
            rivals: &["crosstalk", "camber", "tors_stiff"],
            experiment: "dead weights for the balance's part; an airspeed sweep",
        }
    }

    fn parameters(&self) -> Vec<Parameter> {
        vec![Parameter::new("dx_over_c", (-0.1, 0.1), 0.02)]
    }

    fn change(&self, p: &[f64], _place: &Place<'_>, change: &mut Change) {
        change.zone_aft_over_c.iter_mut().for_each(|aft| *aft += p[0]);
    }
}
