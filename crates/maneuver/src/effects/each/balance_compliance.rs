//! The balance or sting gives way: the root turns nose up under My, and the wing meets the air at another angle.
//! The parameter is the compliance 1/k_theta. Inertia of that turning is left out.

use super::prelude::*;

/// See the module.
#[derive(Debug)]
pub(crate) struct BalanceCompliance;

impl Effect for BalanceCompliance {
    fn spec(&self) -> &'static Spec {
        &Spec {
            name: "balance_compliance",
            title: "the root turns under load",
            side: Side::Balance,
            rivals: &["lift_slope", "tors_stiff", "bend_stiff"],
            experiment: "the root's pose under load, by camera",
        }
    }

    fn parameters(&self) -> Vec<Parameter> {
        vec![Parameter::new("compliance_rad_per_Nm", (0.0, 0.002), 0.0003)]
    }

    fn change(&self, p: &[f64], _place: &Place<'_>, change: &mut Change) {
        change.incidence_by_my += p[0];
    }
}
