//! Servos are not those of the wing's file: another period and damping, slower or quicker (without a period: no servo at all);
//! or one more lag of first order, or of second order (Butterworth) with the same delay at rest.

use crate::effects::prelude::*;

/// See the module.
pub(super) const FORMS: &[Declaration] = &[
    SERVO,
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

const SERVO: Declaration = Declaration {
    spec: Spec {
        name: "act_lag",
        title: "servos lag more or less than modelled",
        side: Side::Control,
        rivals: &["delay", "daq_filter", "aero_lag", "ctl_saturation"],
        experiment: "runs of root pitch: a lag of the balance shows there too",
    },
    form: "servo",
    parameters: |_| {
        let share = |name: &str, lower| Parameter::new(name, lower..=4.0, 0.3);
        vec![share("period_share", -1.0), share("damping_share", -0.9)]
    },
    // a lag turns phases, in proportion to nothing: no servo, the file's own, and periods between and beyond
    starts: &[&[-0.95, 0.0], &[-0.6, 0.0], &[0.0, 0.0], &[0.4, 0.0], &[0.8, 0.0], &[1.3, 0.0], &[2.0, 0.0]],
    known: |known, parameters| {
        for (parameter, sd) in parameters.iter_mut().zip(known.servos.relative_sd()) {
            parameter.know(Calibration::Servos, sd);
        }
    },
    servos: |p, servos| *servos = servos.changed(p[0], p[1]),
    ..Declaration::NONE
};

const FIRST_ORDER: Declaration = Declaration {
    spec: SERVO.spec,
    form: "first order",
    parameters: |_| vec![Parameter::new("tau_s", 0.0..=0.3, 0.03)],
    known: |known, parameters| {
        // the delay at rest of what is known is that of period times damping
        let [period, damping] = known.servos.relative_sd();
        parameters[0]
            .know(Calibration::Servos, Actuator::from(known.servos).delay_s() * period.hypot(damping));
    },
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
