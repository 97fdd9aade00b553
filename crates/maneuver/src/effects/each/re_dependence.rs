//! Lift slope and zero-lift angle change with Reynolds number, hence with airspeed, beyond dynamic pressure:
//! factors of `V_ref/V - 1`.

use super::prelude::*;

/// See the module.
#[derive(Debug)]
pub(crate) struct ReDependence;

impl Effect for ReDependence {
    fn spec(&self) -> &'static Spec {
        &Spec {
            name: "re_dependence",
            title: "low Reynolds number changes slope and zero lift",
            side: Side::Aerodynamics,
            rivals: &["bend_stiff", "tors_stiff", "q_error"],
            experiment: "trip strips; five airspeeds or more",
        }
    }

    fn parameters(&self) -> Vec<Parameter> {
        vec![Parameter::new("r", (-0.5, 0.5), 0.1), Parameter::new("r0_deg", (-3.0, 3.0), 0.5)]
    }

    fn inputs(&self, p: &[f64], place: &Place<'_>, inputs: &mut Inputs) {
        if place.flow.v_m_s > 0.0 {
            let more = p[1].to_radians() * (REFERENCE_V_M_S / place.flow.v_m_s - 1.0);
            inputs.incidence_rad.iter_mut().for_each(|value| *value += more);
        }
    }

    fn change(&self, p: &[f64], place: &Place<'_>, change: &mut Change) {
        if place.flow.v_m_s > 0.0 {
            change.lift_slope += p[0] * (REFERENCE_V_M_S / place.flow.v_m_s - 1.0);
        }
    }
}
