//! The stream's angle grows along the span.

use super::prelude::*;

/// See the module.
#[derive(Debug)]
pub(crate) struct FlowUpwashGradient;

impl Effect for FlowUpwashGradient {
    fn spec(&self) -> &'static Spec {
        &Spec {
            name: "flow_upwash_gradient",
            title: "upwash of the stream grows along the span",
            side: Side::Flow,
            rivals: &["alpha_offset", "camber"],
            experiment: "a flow survey; an inverted run",
        }
    }

    fn parameters(&self) -> Vec<Parameter> {
        vec![Parameter::new("a1_deg_per_m", (-2.0, 2.0), 0.4)]
    }

    fn constants(&self, p: &[f64], _place: &Place<'_>, constants: &mut Constants) {
        constants.upwash_rad_m += p[0].to_radians();
    }
}
