//! A rigid body between balance and wing root (joiner, turntable, adapter) that no model has: it turns with the wing on the
//! balance's metric side.
//!
//! Forces of inertia and weight of a body whose centre is (x aft, y, z up) of the balance point, in axes that pitch with
//! it: `Fz += m x a''`, `Mx += g m y (1 - cos a)`, `My += -I a'' + g m z sin a - g m x (1 - cos a)`, the tare at alpha = 0
//! taken off. Left out are what its mass alone does to Fz, `m g (1 - cos a)`, and its product of inertia `m x y`.

use crate::effects::prelude::*;

/// No adapter is heavier, kg.
const LARGEST_MASS_KG: f64 = 10.0;

/// See the module.
pub(super) const FORMS: &[Declaration] = &[Declaration {
    spec: Spec {
        name: "joiner_inertia",
        title: "a rigid body between balance and wing root that the model lacks (joiner)",
        side: Side::Balance,
        rivals: &["added_mass", "wing_mass_error", "crosstalk", "delay"],
        experiment: "wind-off pitch at 2, 4 and 6 Hz, and a wind-off tilt",
    },
    parameters: |_| {
        vec![
            Parameter::new("mx_kg_m", -0.3..=0.3, 0.05),
            Parameter::new("Iyy_kg_m2", 0.0..=0.5, 0.05),
            Parameter::new("mz_kg_m", -0.5..=0.5, 0.05),
            Parameter::new("my_kg_m", -1.0..=1.0, 0.1),
        ]
    },
    constrain,
    loads,
    ..Declaration::NONE
}];

/// A body's first moments are bounded by its inertia and a largest mass: `(m x)² + (m z)² <= m I`.
fn constrain(p: &mut [f64]) {
    let room = (LARGEST_MASS_KG * p[1].max(0.0)).sqrt();
    let arm = p[0].hypot(p[2]);
    if arm > room {
        let shorter = room / arm;
        p[0] *= shorter;
        p[2] *= shorter;
    }
}

fn loads(p: &[f64], place: &Place<'_>, state: &WingState<'_>, loads: &mut Loads) {
    let [mx, iyy, mz, my] = [p[0], p[1], p[2], p[3]];
    let g = place.gravity_m_s2;
    for i in 0..state.len() {
        let (a, second) = (state.inputs.alpha.value[i], state.inputs.alpha.second[i]);
        let (sin, cos) = a.sin_cos();
        let lighter = g * (1.0 - cos);
        loads.balance[0][i] += mx * second;
        loads.balance[1][i] += my * lighter;
        loads.balance[2][i] += -iyy * second + g * mz * sin - mx * lighter;
    }
}
