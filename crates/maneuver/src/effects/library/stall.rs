//! Beyond an effective angle lift grows less: `a -= k (|a| - limit)`, a the angle that is left (lift over q S
//! 2 pi), hence of what a strip would exceed the limit by without loss, k/(1 + k) is lost: lift never falls.
//! The first parameter says how far below 16 degrees the limit lies, so that zero is no stall.
//! In the form `angle` a is the angle of the stream alone: pitch, twist, and what the zone's own motion adds; a deflected flap
//! does not bring the flow to separate.

use crate::effects::prelude::*;

/// See the module.
pub(super) const FORMS: &[Declaration] = &[
    BY_LIFT,
    Declaration {
        form: "angle",
        // the angle of the stream is smaller than that of a cambered strip's lift: this form sets in lower
        parameters: |_| parameters(12.0),
        needs: Needs { height: true, twist: true, ..Needs::NONE },
        forces: |p, place, state, forces| {
            lose(p, place, forces, |zone, i, by_angle| stream_angle(place, state, zone, i) * by_angle);
        },
        ..BY_LIFT
    },
];

const BY_LIFT: Declaration = Declaration {
    spec: Spec {
        name: "stall",
        title: "lift saturates beyond an angle",
        side: Side::Aerodynamics,
        rivals: &["q_error", "balance_nonlin", "dynamic_stall"],
        experiment: "a wide sweep of angles, up and down",
    },
    parameters: |_| parameters(8.0),
    // stall from 3, 5 and 8 degrees on, and a little loss late: from the others the way there leads over more than all lift
    starts: &[&[13.0, 0.3], &[11.0, 0.3], &[8.0, 0.3], &[10.5, 0.07]],
    needs: Needs::LIFT,
    forces: |p, place, state, forces| lose(p, place, forces, |zone, i, _| state.lift_n[zone][i]),
    holds_at_rest_only: true,
    ..Declaration::NONE
};

fn parameters(earlier_deg: f64) -> Vec<Parameter> {
    vec![Parameter::new("earlier_than_16_deg", 0.0..=14.0, earlier_deg), Parameter::new("k", 0.0..=3.0, 0.5)]
}

/// Takes off every zone's lift what it loses of the lift that it would carry without loss, by zone, sample and lift by angle.
fn lose(p: &[f64], place: &Place<'_>, forces: &mut Forces, attached_n: impl Fn(usize, usize, f64) -> f64) {
    let limit_rad = separation::limit_rad(p[0]);
    for (zone, lift_n) in forces.lift_n.iter_mut().enumerate() {
        let by_angle = separation::lift_by_angle(place, zone);
        for (i, lift_n) in lift_n.iter_mut().enumerate() {
            *lift_n -= separation::stalled(attached_n(zone, i, by_angle), by_angle, limit_rad, p[1]);
        }
    }
}

/// Pitch and elastic twist, less what the zone's own motion takes off: its height's rate over the airspeed.
fn stream_angle(place: &Place<'_>, state: &WingState<'_>, zone: usize, i: usize) -> f64 {
    let given = state.inputs.alpha.value[i] + state.inputs.incidence_rad[i] + state.twist_rad[zone][i];
    if place.steady || place.flow.v_m_s <= 0.0 {
        return given;
    }
    let height = &state.height_m[zone];
    let (before, after) = (i.saturating_sub(1), (i + 1).min(height.len() - 1));
    let steps = (after - before).max(1) as f64;
    given - (height[after] - height[before]) / (steps * place.time_step_s * place.flow.v_m_s)
}
