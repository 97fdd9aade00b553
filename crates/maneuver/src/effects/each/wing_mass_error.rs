//! The wing is heavier or lighter than modelled, in proportion everywhere.

use super::prelude::*;

/// See the module.
#[derive(Debug)]
pub(crate) struct WingMassError;

impl Effect for WingMassError {
    fn spec(&self) -> &'static Spec {
        &Spec {
            name: "wing_mass_error",
            title: "mass of the wing off by a factor",
            side: Side::Structure,
            rivals: &["joiner_inertia", "tip_mass", "bend_stiff"],
            experiment: "weighing, and wind-off pitch",
        }
    }

    fn parameters(&self) -> Vec<Parameter> {
        vec![Parameter::new("dm_over_m", (-0.3, 0.3), 0.05)]
    }

    fn change(&self, p: &[f64], _place: &Place<'_>, change: &mut Change) {
        change.mass += p[0];
    }
}
