//! Beyond an effective angle lift grows less: `a -= k (|a| - limit)`, a the angle that is left (lift over q S
//! 2 pi), hence of what a strip would exceed the limit by without loss, k/(1 + k) is lost: lift never falls.
//! The first parameter says how far below 16 degrees the limit lies, so that zero is no stall.

use super::prelude::*;

/// See the module.
#[derive(Debug)]
pub(crate) struct Stall;

impl Effect for Stall {
    fn spec(&self) -> &'static Spec {
        &Spec {
            name: "stall",
            title: "lift saturates beyond an angle",
            side: Side::Aerodynamics,
            rivals: &["q_error", "balance_nonlin", "dynamic_stall"],
            experiment: "a wide sweep of angles, up and down",
        }
    }

    fn parameters(&self) -> Vec<Parameter> {
        vec![Parameter::new("earlier_than_16_deg", (0.0, 14.0), 8.0), Parameter::new("k", (0.0, 3.0), 0.5)]
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
