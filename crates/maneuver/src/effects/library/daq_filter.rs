//! The balance's amplifiers filter more than known: a low pass of two poles, or of four (two such filters one after the
//! other with twice the corner: the same delay at rest); the parameter is the inverse corner, so that zero is none.

use crate::effects::prelude::*;

/// See the module.
pub(super) const FORMS: &[Declaration] = &[
    TWO_POLES,
    Declaration { form: "four poles", loads: |p, place, _, loads| filter(p, place, loads, 2), ..TWO_POLES },
];

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
