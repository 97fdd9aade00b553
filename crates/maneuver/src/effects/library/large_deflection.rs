//! A wing that bends far reaches less far out, and its lift leans inward: arms shorten by half the integral of the
//! slope squared, Fz by half the slope squared, and the inward part pushes at the wing's height:
//! `Mx += -lift (shorter + slope² y/2 - slope z)`. One is the geometry's own size, to second order.
//!
//! For a circular arc under a load at its end, which leans by theta, Mx is `F L sin(theta)/theta`.

use crate::effects::prelude::*;

/// See the module.
pub(super) const FORMS: &[Declaration] = &[Declaration {
    spec: Spec {
        name: "large_deflection",
        title: "arm shortening and tilt of the lift at large bending",
        side: Side::Structure,
        rivals: &["stall", "lift_slope", "balance_nonlin"],
        experiment: "the tip's deflection measured; wide angles at high q",
    },
    parameters: |_| vec![Parameter::new("scale", 0.0..=2.0, 0.5)],
    needs: Needs { lift: true, height: true, ..Needs::NONE },
    loads,
    holds_at_rest_only: true,
    ..Declaration::NONE
}];

fn loads(p: &[f64], place: &Place<'_>, state: &WingState<'_>, loads: &mut Loads) {
    let zones = || place.zones.y_m.iter().zip(state.lift_n.iter().zip(state.height_m));
    for i in 0..state.len() {
        let (mut shorter, mut inner_m, mut inner_h) = (0.0, place.balance_y_m, 0.0);
        for (&y, (lift, height)) in zones() {
            let (lift, height) = (lift[i], height[i]);
            let run = (y - inner_m).max(f64::MIN_POSITIVE);
            let slope = (height - inner_h) / run;
            shorter += 0.5 * slope * slope * run;
            (inner_m, inner_h) = (y, height);
            let lost = 0.5 * slope * slope * lift;
            loads.balance[0][i] -= p[0] * lost;
            let raised = slope * height;
            loads.balance[1][i] -= p[0] * (lift * (shorter - raised) + lost * (y - place.balance_y_m));
        }
    }
}
