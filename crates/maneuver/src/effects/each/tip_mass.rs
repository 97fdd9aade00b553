//! A mass on the wing that the model lacks: a pod, a servo, a cable.

use super::prelude::*;

/// See the module.
#[derive(Debug)]
pub(crate) struct TipMass;

impl Effect for TipMass {
    fn spec(&self) -> &'static Spec {
        &Spec {
            name: "tip_mass",
            title: "unmodelled mass on the outer wing",
            side: Side::Structure,
            rivals: &["bend_stiff", "wing_mass_error"],
            experiment: "wind-off pitch: mass changes it, stiffness alone does not change the static deflection",
        }
    }

    fn parameters(&self) -> Vec<Parameter> {
        vec![Parameter::new("m_kg", (0.0, 0.4), 0.05)]
    }

    fn change(&self, p: &[f64], _place: &Place<'_>, change: &mut Change) {
        if p[0] != 0.0 {
            change.points.push(PointMass { mass_kg: p[0], y_norm: 0.97, aft_over_c: 0.2 });
        }
    }
}
