//! The wing stiffens as it bends: the first mode's stiffness times `1 + k3 z²`, z the tip's height.

use super::prelude::*;

/// See the module.
#[derive(Debug)]
pub(crate) struct CubicStiffness;

impl Effect for CubicStiffness {
    fn spec(&self) -> &'static Spec {
        &Spec {
            name: "cubic_stiffness",
            title: "bending stiffens with deflection",
            side: Side::Structure,
            rivals: &["stall", "large_deflection"],
            experiment: "amplitudes at resonance, without wind",
        }
    }

    fn parameters(&self) -> Vec<Parameter> {
        vec![Parameter::new("k3_per_m2", (0.0, 20.0), 3.0)]
    }

    fn needs_zones(&self) -> bool {
        true
    }

    fn forces(&self, p: &[f64], place: &Place<'_>, seen: &Seen<'_>, forces: &mut Forces) {
        let Some(outer) = seen.height_m.last() else { return };
        let shape = place.outer_shape;
        if shape == 0.0 {
            return;
        }
        for (modal, z) in forces.modal[0].iter_mut().zip(outer) {
            *modal -= p[0] * z * z * place.first_stiffness * z / shape;
        }
    }
}
