//! Apparent mass of the air is off by a factor.

use super::prelude::*;

/// See the module.
#[derive(Debug)]
pub(crate) struct AddedMass;

impl Effect for AddedMass {
    fn spec(&self) -> &'static Spec {
        &Spec {
            name: "added_mass",
            title: "apparent mass of the air",
            side: Side::Aerodynamics,
            rivals: &["joiner_inertia", "wing_mass_error"],
            experiment: "runs in air beside the weighed inertia; it does not depend on airspeed",
        }
    }

    fn parameters(&self) -> Vec<Parameter> {
        vec![Parameter::new("dam", (-0.95, 4.0), 0.5)]
    }

    fn change(&self, p: &[f64], _place: &Place<'_>, change: &mut Change) {
        change.apparent_mass += p[0];
    }
}
