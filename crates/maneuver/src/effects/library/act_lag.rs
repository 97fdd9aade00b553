//! Servos lag behind what the model has: one more lag of first order, or of second order (Butterworth) with the same
//! delay at rest.

use crate::effects::prelude::*;

/// See the module.
pub(super) const FORMS: &[Declaration] = &[
    FIRST_ORDER,
    Declaration {
        form: "second order",
        inputs: |p, place, inputs| {
            let corner_hz = std::f64::consts::SQRT_2 / (std::f64::consts::TAU * p[0]);
            lag(p, place, inputs, |control| signal::second_order(control, place.time_step_s, corner_hz));
        },
        ..FIRST_ORDER
    },
];

const FIRST_ORDER: Declaration = Declaration {
    spec: Spec {
        name: "act_lag",
        title: "servos lag more than modelled",
        side: Side::Control,
        rivals: &["delay", "daq_filter", "aero_lag", "ctl_saturation"],
        experiment: "runs of root pitch: a lag of the balance shows there too",
    },
    form: "first order",
    parameters: |_| vec![Parameter::new("tau_s", 0.0..=0.3, 0.03).calibrated(Calibration::Servos, 0.001)],
    inputs: |p, place, inputs| {
        lag(p, place, inputs, |control| signal::first_order(control, place.time_step_s, p[0]));
    },
    ..Declaration::NONE
};

fn lag(p: &[f64], place: &Place<'_>, inputs: &mut Inputs, lagged: impl Fn(&[f64]) -> Vec<f64>) {
    if !place.steady && p[0] > 0.0 {
        inputs.controls_rad.iter_mut().for_each(|control| *control = lagged(control));
    }
}
