//! Separation follows the angle late: what stall takes off passes a lag of `t c/V`.
//! The first parameter says how far below 16 degrees the limit lies, as for stall without a lag.

use crate::effects::prelude::*;

/// See the module.
pub(super) const FORMS: &[Declaration] = &[Declaration {
    spec: Spec {
        name: "dynamic_stall",
        title: "stall with a lag",
        side: Side::Aerodynamics,
        rivals: &["stall", "aero_lag", "static_hysteresis"],
        experiment: "one minus cosine into stall at three rates",
    },
    parameters: |_| {
        vec![
            Parameter::new("earlier_than_16_deg", 0.0..=14.0, 8.0),
            Parameter::new("k", 0.0..=3.0, 0.5),
            Parameter::new("chords", 0.0..=20.0, 5.0),
        ]
    },
    // stall from 3, 5 and 8 degrees on
    starts: &[&[13.0, 0.3, 5.0], &[11.0, 0.3, 5.0], &[8.0, 0.3, 5.0]],
    needs: Needs::LIFT,
    forces,
    holds_at_rest_only: true,
    ..Declaration::NONE
}];

fn forces(p: &[f64], place: &Place<'_>, state: &WingState<'_>, forces: &mut Forces) {
    let limit_rad = separation::limit_rad(p[0]);
    for zone in 0..forces.lift_n.len() {
        let by_angle = separation::lift_by_angle(place, zone);
        if by_angle == 0.0 || p[1] == 0.0 {
            continue;
        }
        let lost = |lift: &f64| separation::stalled(*lift, by_angle, limit_rad, p[1]);
        let mut late: Vec<f64> = state.lift_n[zone].iter().map(lost).collect();
        if !place.steady {
            let lag_s = p[2] * place.zones.chord_m[zone] / place.flow.v_m_s;
            late = signal::first_order(&late, place.time_step_s, lag_s);
        }
        for (lift, late) in forces.lift_n[zone].iter_mut().zip(late) {
            *lift -= late;
        }
    }
}
