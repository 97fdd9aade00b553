//! The linkage gives way under the hinge moment: the surface turns back in proportion to dynamic pressure.

use super::prelude::*;

/// Commands over what the surface does: it turns no further than five times its command.
const SMALLEST: f64 = 0.2;

/// See the module.
#[derive(Debug)]
pub(crate) struct CtlCompliance;

impl Effect for CtlCompliance {
    fn spec(&self) -> &'static Spec {
        &Spec {
            name: "ctl_compliance",
            title: "the linkage gives way",
            side: Side::Control,
            rivals: &["ctl_scale", "tors_stiff"],
            experiment: "an airspeed sweep at one deflection; a potentiometer at the surface",
        }
    }

    fn parameters(&self) -> Vec<Parameter> {
        vec![Parameter::new("k_at_30_m_s", (-0.3, 2.0), 0.15)]
    }

    fn inputs(&self, p: &[f64], place: &Place<'_>, inputs: &mut Inputs) {
        // a linkage that turns the surface further must not turn it round
        let less = 1.0 / (1.0 + p[0] * place.q_over_reference()).max(SMALLEST);
        inputs.controls_rad.iter_mut().flatten().for_each(|delta| *delta *= less);
    }
}
