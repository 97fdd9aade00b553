//! Cables and tubes across the balance are a spring against turning.

use super::prelude::*;

/// See the module.
#[derive(Debug)]
pub(crate) struct CableStiffness;

impl Effect for CableStiffness {
    fn spec(&self) -> &'static Spec {
        &Spec {
            name: "cable_stiffness",
            title: "stiffness of cables across the balance",
            side: Side::Sensor,
            rivals: &["joiner_inertia", "friction"],
            experiment: "a tilt without wind, with and without cables",
        }
    }

    fn parameters(&self) -> Vec<Parameter> {
        vec![Parameter::new("k_c_Nm_per_rad", (0.0, 20.0), 3.0)]
    }

    fn loads(&self, p: &[f64], _place: &Place<'_>, seen: &Seen<'_>, loads: &mut Loads) {
        for i in 0..seen.len() {
            loads.balance[2][i] -= p[0] * seen.inputs.alpha.value[i];
        }
    }
}
