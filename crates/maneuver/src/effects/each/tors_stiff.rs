//! Torsional stiffness is off by a factor.

use super::prelude::*;

/// See the module.
#[derive(Debug)]
pub(crate) struct TorsStiff;

impl Effect for TorsStiff {
    fn spec(&self) -> &'static Spec {
        &Spec {
            name: "tors_stiff",
            title: "torsional stiffness",
            side: Side::Structure,
            rivals: &["ac_shift", "ctl_compliance", "re_dependence"],
            experiment: "a chirp to 20 Hz; an airspeed sweep; a dead torque",
        }
    }

    fn parameters(&self) -> Vec<Parameter> {
        vec![Parameter::new("dGJ", (-0.7, 2.0), 0.25)]
    }

    fn change(&self, p: &[f64], _place: &Place<'_>, change: &mut Change) {
        change.torsion += p[0];
    }
}
