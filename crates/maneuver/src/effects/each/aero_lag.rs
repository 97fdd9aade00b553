//! The wake remembers longer or shorter than the doublet lattice says.

use super::prelude::*;

/// See the module.
#[derive(Debug)]
pub(crate) struct AeroLag;

impl Effect for AeroLag {
    fn spec(&self) -> &'static Spec {
        &Spec {
            name: "aero_lag",
            title: "lag of the wake",
            side: Side::Aerodynamics,
            rivals: &["delay", "act_lag", "added_mass"],
            experiment: "a frequency sweep at two airspeeds: it collapses on reduced frequency",
        }
    }

    fn parameters(&self) -> Vec<Parameter> {
        vec![Parameter::new("dlag", (-0.8, 5.0), 0.5)]
    }

    fn change(&self, p: &[f64], _place: &Place<'_>, change: &mut Change) {
        change.lag += p[0];
    }
}
