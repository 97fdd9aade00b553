//! The balance's amplifiers filter more than known: a low pass of Butterworth of two poles, or of four (two such filters one after the
//! other with twice the corner), or Bessel's of four, which amplifiers offer beside it; all with the same delay of slow loads. The parameter is
//! the inverse corner of the first, so that zero is none.

use crate::effects::prelude::*;

/// See the module.
pub(super) const FORMS: &[Declaration] = &[
    TWO_POLES,
    Declaration { form: "four poles", loads: |p, place, _, loads| filter(p, place, loads, 2), ..TWO_POLES },
    Declaration { form: "Bessel", loads: bessel, ..TWO_POLES },
];

/// Natural frequencies times the delay, rad, and damping ratios of the two pairs of poles of `s⁴ + 10 s³ + 45 s² + 105 s + 105`
/// (Thomson 1949), whose delay is one.
const PAIRS: [(f64, f64); 2] = [(3.023_265, 0.957_974), (3.389_366, 0.620_703)];

const TWO_POLES: Declaration = Declaration {
    spec: Spec {
        name: "daq_filter",
        title: "low pass of the balance's amplifiers",
        side: Side::Sensor,
        rivals: &["delay", "act_lag"],
        experiment: "a chirp to 20 Hz",
    },
    form: "two poles",
    parameters: |_| vec![Parameter::new("inverse_corner_s", 0.0..=0.4, 0.05)],
    stage: Stage::Record,
    loads: |p, place, _, loads| filter(p, place, loads, 1),
    ..Declaration::NONE
};

/// By a number of filters of two poles, one after the other.
fn filter(p: &[f64], place: &Place<'_>, loads: &mut Loads, pairs: u8) {
    if !place.steady && p[0] > 0.0 {
        for channel in &mut loads.balance {
            for _ in 0..pairs {
                *channel = signal::second_order(channel, place.time_step_s, f64::from(pairs) / p[0]);
            }
        }
    }
}

fn bessel(p: &[f64], place: &Place<'_>, _: &WingState<'_>, loads: &mut Loads) {
    if !place.steady && p[0] > 0.0 {
        let delay_s = std::f64::consts::SQRT_2 * p[0] / std::f64::consts::TAU;
        for channel in &mut loads.balance {
            for (omega, damping_ratio) in PAIRS {
                let frequency_hz = omega / (std::f64::consts::TAU * delay_s);
                *channel =
                    signal::damped(channel, place.time_step_s, Actuator { frequency_hz, damping_ratio });
            }
        }
    }
}
