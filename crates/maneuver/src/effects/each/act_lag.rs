//! Servos lag behind what the model has: one more lag of first order.

use super::prelude::*;

/// See the module.
#[derive(Debug)]
pub(crate) struct ActLag;

impl Effect for ActLag {
    fn spec(&self) -> &'static Spec {
        &Spec {
            name: "act_lag",
            title: "servos lag more than modelled",
            side: Side::Control,
            rivals: &["delay", "daq_filter", "aero_lag"],
            experiment: "runs of root pitch: a lag of the balance shows there too",
        }
    }

    fn parameters(&self) -> Vec<Parameter> {
        vec![Parameter::new("tau_s", (0.0, 0.3), 0.03)]
    }

    fn inputs(&self, p: &[f64], place: &Place<'_>, inputs: &mut Inputs) {
        if !place.steady {
            for control in &mut inputs.controls_rad {
                *control = signal::first_order(control, place.time_step_s, p[0]);
            }
        }
    }
}
