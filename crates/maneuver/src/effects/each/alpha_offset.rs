//! The stream is inclined, or the angle's zero is off: the air sees another angle than gravity.

use super::prelude::*;

/// See the module.
#[derive(Debug)]
pub(crate) struct AlphaOffset;

impl Effect for AlphaOffset {
    fn spec(&self) -> &'static Spec {
        &Spec {
            name: "alpha_offset",
            title: "zero of the angle of attack, or inclination of the stream",
            side: Side::Flow,
            rivals: &["camber", "flow_upwash_gradient", "drift"],
            experiment: "an inverted run",
        }
    }

    fn parameters(&self) -> Vec<Parameter> {
        vec![Parameter::new("a0_deg", (-3.0, 3.0), 0.5)]
    }

    fn inputs(&self, p: &[f64], place: &Place<'_>, inputs: &mut Inputs) {
        if place.flow.v_m_s > 0.0 {
            inputs.incidence_rad.iter_mut().for_each(|value| *value += p[0].to_radians());
        }
    }
}
