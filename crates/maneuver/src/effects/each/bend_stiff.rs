//! Bending stiffness is off by a factor.

use super::prelude::*;

/// See the module.
#[derive(Debug)]
pub(crate) struct BendStiff;

impl Effect for BendStiff {
    fn spec(&self) -> &'static Spec {
        &Spec {
            name: "bend_stiff",
            title: "bending stiffness",
            side: Side::Structure,
            rivals: &["tip_mass", "tip_loss", "wing_mass_error"],
            experiment: "a dead weight at the tip; wind-off pitch",
        }
    }

    fn parameters(&self) -> Vec<Parameter> {
        vec![Parameter::new("dEI", (-0.6, 1.0), 0.15)]
    }

    fn change(&self, p: &[f64], _place: &Place<'_>, change: &mut Change) {
        change.bending += p[0];
    }
}
