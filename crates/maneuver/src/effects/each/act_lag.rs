//! Servos lag behind what the model has: one more lag of first order, or of second order (Butterworth) with the same
//! delay at rest.

use super::prelude::*;

/// See the module.
#[derive(Debug)]
pub(crate) struct ActLag {
    /// Whether it is of second order.
    pub(crate) second_order: bool,
}

impl Effect for ActLag {
    fn spec(&self) -> &'static Spec {
        &Spec {
            name: "act_lag",
            title: "servos lag more than modelled",
            side: Side::Control,
            rivals: &["delay", "daq_filter", "aero_lag", "ctl_saturation"],
            experiment: "runs of root pitch: a lag of the balance shows there too",
        }
    }

    fn form(&self) -> &'static str {
        if self.second_order { "second order" } else { "first order" }
    }

    fn parameters(&self) -> Vec<Parameter> {
        vec![Parameter::new("tau_s", (0.0, 0.3), 0.03)]
    }

    fn inputs(&self, p: &[f64], place: &Place<'_>, inputs: &mut Inputs) {
        if place.steady || p[0] <= 0.0 {
            return;
        }
        for control in &mut inputs.controls_rad {
            *control = if self.second_order {
                let corner_hz = std::f64::consts::SQRT_2 / (std::f64::consts::TAU * p[0]);
                signal::second_order(control, place.time_step_s, corner_hz)
            } else {
                signal::first_order(control, place.time_step_s, p[0])
            };
        }
    }
}
