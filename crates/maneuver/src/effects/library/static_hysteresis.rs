//! Separation that starts late and ends late: beyond an angle lift is lost, and comes back only below a smaller one.
//! Both angles are fixed; the share of the angle beyond the smaller one that is lost is the parameter.

use crate::effects::prelude::*;

/// Lift is lost from this effective angle on, degrees; four degrees of it are a lift coefficient of .44.
const ON_DEG: f64 = 4.0;
/// Until this one.
const OFF_DEG: f64 = 2.5;

/// See the module.
pub(super) const FORMS: &[Declaration] = &[Declaration {
    spec: Spec {
        name: "static_hysteresis",
        title: "hysteresis of separation",
        side: Side::Aerodynamics,
        rivals: &["friction", "aero_lag", "stall"],
        experiment: "slow sweeps up and down at two rates",
    },
    parameters: |_| vec![Parameter::new("dC_lost", 0.0..=0.5, 0.1)],
    needs: Needs::LIFT,
    forces,
    ..Declaration::NONE
}];

fn forces(p: &[f64], place: &Place<'_>, state: &WingState<'_>, forces: &mut Forces) {
    if p[0] == 0.0 {
        return;
    }
    let [on, off] = [ON_DEG, OFF_DEG].map(f64::to_radians);
    for zone in 0..forces.lift_n.len() {
        let by_angle = separation::lift_by_angle(place, zone);
        if by_angle == 0.0 {
            continue;
        }
        let mut separated = false;
        for i in 0..state.len() {
            let angle = state.lift_n[zone][i] / by_angle;
            separated = if separated && !place.steady { angle.abs() > off } else { angle.abs() > on };
            if separated {
                forces.lift_n[zone][i] -= p[0] * (angle.abs() - off) * angle.signum() * by_angle;
            }
        }
    }
}
