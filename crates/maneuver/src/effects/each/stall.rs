//! Beyond an effective angle lift grows less: `a -= k (|a| - limit)`, a the angle that is left (lift over q S
//! 2 pi), hence of what a strip would exceed the limit by without loss, k/(1 + k) is lost: lift never falls.
//! The first parameter says how far below 16 degrees the limit lies, so that zero is no stall.
//! In the form `angle` a is the angle of the stream alone: pitch, twist, and what the zone's own motion adds; a deflected flap
//! does not bring the flow to separate.

use super::prelude::*;

/// Beginnings that a fit tries: stall from 3, 5 and 8 degrees on.
pub(super) const STARTS: [f64; 3] = [13.0, 11.0, 8.0];

const SPEC: Spec = Spec {
    name: "stall",
    title: "lift saturates beyond an angle",
    side: Side::Aerodynamics,
    rivals: &["q_error", "balance_nonlin", "dynamic_stall"],
    experiment: "a wide sweep of angles, up and down",
};

/// The form of the lift.
#[derive(Debug)]
pub(crate) struct Stall;

impl Effect for Stall {
    fn spec(&self) -> &'static Spec {
        &SPEC
    }

    fn parameters(&self) -> Vec<Parameter> {
        parameters(8.0)
    }

    fn starts(&self) -> Vec<Vec<f64>> {
        starts()
    }

    fn needs_zones(&self) -> bool {
        true
    }

    fn forces(&self, p: &[f64], place: &Place<'_>, seen: &Seen<'_>, forces: &mut Forces) {
        let limit = (16.0 - p[0]).to_radians();
        for zone in 0..forces.lift_n.len() {
            let by_angle = lift_by_angle(place, zone);
            for i in 0..seen.len() {
                // of what the strip would carry without loss
                forces.lift_n[zone][i] -= stalled(seen.lift_n[zone][i], by_angle, limit, p[1]);
            }
        }
    }
}

/// The angle of the stream is smaller than that of a cambered strip's lift: the form of the angle sets in lower.
fn parameters(earlier_deg: f64) -> Vec<Parameter> {
    vec![
        Parameter::new("earlier_than_16_deg", (0.0, 14.0), earlier_deg),
        Parameter::new("k", (0.0, 3.0), 0.5),
    ]
}

fn starts() -> Vec<Vec<f64>> {
    let mut starts: Vec<Vec<f64>> = STARTS.iter().map(|earlier| vec![*earlier, 0.3]).collect();
    // a little loss late: from the others the way there leads over more than all lift
    starts.push(vec![10.5, 0.07]);
    starts
}

/// The form of the angle.
#[derive(Debug)]
pub(crate) struct StallByAngle;

impl Effect for StallByAngle {
    fn spec(&self) -> &'static Spec {
        &SPEC
    }

    fn form(&self) -> &'static str {
        "angle"
    }

    fn parameters(&self) -> Vec<Parameter> {
        parameters(12.0)
    }

    fn starts(&self) -> Vec<Vec<f64>> {
        starts()
    }

    fn needs_zones(&self) -> bool {
        true
    }

    fn forces(&self, p: &[f64], place: &Place<'_>, seen: &Seen<'_>, forces: &mut Forces) {
        let limit = (16.0 - p[0]).to_radians();
        for zone in 0..forces.lift_n.len() {
            let by_angle = lift_by_angle(place, zone);
            for i in 0..seen.len() {
                let angle = stream_angle(place, seen, zone, i);
                forces.lift_n[zone][i] -= stalled(angle * by_angle, by_angle, limit, p[1]);
            }
        }
    }
}

/// Pitch and elastic twist, less what the zone's own motion takes off: its height's rate over the airspeed.
fn stream_angle(place: &Place<'_>, seen: &Seen<'_>, zone: usize, i: usize) -> f64 {
    let given = seen.inputs.alpha.value[i] + seen.inputs.incidence_rad[i] + seen.twist_rad[zone][i];
    if place.steady || place.flow.v_m_s <= 0.0 {
        return given;
    }
    let height = &seen.height_m[zone];
    let (before, after) = (i.saturating_sub(1), (i + 1).min(height.len() - 1));
    let steps = (after - before).max(1) as f64;
    given - (height[after] - height[before]) / (steps * place.time_step_s * place.flow.v_m_s)
}
