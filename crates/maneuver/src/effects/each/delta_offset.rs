//! Control surfaces are rigged a little off, all by one angle.

use super::prelude::*;

/// See the module.
#[derive(Debug)]
pub(crate) struct DeltaOffset;

impl Effect for DeltaOffset {
    fn spec(&self) -> &'static Spec {
        &Spec {
            name: "delta_offset",
            title: "control surfaces are rigged off zero",
            side: Side::Control,
            rivals: &["camber", "alpha_offset"],
            experiment: "a check of every surface's zero",
        }
    }

    fn parameters(&self) -> Vec<Parameter> {
        vec![Parameter::new("d0_deg", (-5.0, 5.0), 1.0)]
    }

    fn inputs(&self, p: &[f64], place: &Place<'_>, inputs: &mut Inputs) {
        if place.flow.v_m_s > 0.0 {
            inputs.controls_rad.iter_mut().flatten().for_each(|delta| *delta += p[0].to_radians());
        }
    }
}
