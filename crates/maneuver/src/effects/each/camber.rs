//! Zero-lift angle and zero-lift moment of the sections are off (camber, twist): f_j^e/q of the calibration.

use super::prelude::*;

/// See the module.
#[derive(Debug)]
pub(crate) struct Camber;

impl Effect for Camber {
    fn spec(&self) -> &'static Spec {
        &Spec {
            name: "camber",
            title: "zero-lift angle or moment of the sections",
            side: Side::Aerodynamics,
            rivals: &["alpha_offset", "drift", "delta_offset"],
            experiment: "My at zero lift over airspeed; an inverted run",
        }
    }

    fn parameters(&self) -> Vec<Parameter> {
        vec![Parameter::new("dcl0_deg", (-4.0, 4.0), 0.5), Parameter::new("dcm0", (-0.1, 0.1), 0.01)]
    }

    fn inputs(&self, p: &[f64], place: &Place<'_>, inputs: &mut Inputs) {
        if place.flow.v_m_s > 0.0 {
            inputs.incidence_rad.iter_mut().for_each(|value| *value += p[0].to_radians());
        }
    }

    fn constants(&self, p: &[f64], _place: &Place<'_>, constants: &mut Constants) {
        constants.moment_coefficient += p[1];
    }
}
