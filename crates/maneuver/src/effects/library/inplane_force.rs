//! Forces along the chord act at the height of the deflected wing: `My += sum Fx z`. Suction pulls forward with the
//! strip's lift times its effective angle, friction pushes aft.

use crate::effects::prelude::*;

/// See the module.
pub(super) const FORMS: &[Declaration] = &[Declaration {
    spec: Spec {
        name: "inplane_force",
        title: "forces along the chord on the deflected wing",
        side: Side::Aerodynamics,
        rivals: &["ac_shift", "crosstalk", "large_deflection"],
        experiment: "an airspeed sweep at one angle; the tip's deflection",
    },
    parameters: |_| vec![Parameter::new("k_s", 0.0..=1.2, 0.3), Parameter::new("cd0", 0.0..=0.03, 0.01)],
    needs: Needs { lift: true, height: true, ..Needs::NONE },
    loads,
    ..Declaration::NONE
}];

fn loads(p: &[f64], place: &Place<'_>, state: &WingState<'_>, loads: &mut Loads) {
    for zone in 0..state.lift_n.len() {
        let by_angle = separation::lift_by_angle(place, zone);
        if by_angle == 0.0 {
            continue;
        }
        for i in 0..state.len() {
            let lift = state.lift_n[zone][i];
            let aft = p[1] * place.q_pa() * place.zones.area_m2[zone] - p[0] * lift * lift / by_angle;
            loads.balance[2][i] += aft * state.height_m[zone][i];
        }
    }
}
