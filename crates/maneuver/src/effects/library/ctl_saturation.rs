//! Control surfaces lose effectiveness at large deflections: K_delta(delta, V) of paper 1, Eq. 10.
//!
//! Three forms. `tanh`: the command is bent before the servo, `delta_eff = s tanh(delta/s)`, by 1/s for each surface, so that
//! zero is no loss. `tanh behind the servo`: what the servo turned is bent alike, by a stop of the surface or by the air on it;
//! the two differ by the inertia of the surface, which no balance of a wing without masses on its surfaces sees.
//! `table`: for each surface what is added to K at 5, 15 and 25 degrees, straight between, constant outside, where tanh
//! does not fit: an effectiveness above one. In all, what differs from one grows with airspeed by a common power, the last
//! parameter.

use crate::effects::prelude::*;

/// Deflections of the table, degrees.
const NODES_DEG: [f64; 3] = [5.0, 15.0, 25.0];
/// Their number.
const NODES: usize = NODES_DEG.len();

/// A table that differs by less than this of its largest entry between its ends is a scale at all deflections, no saturation.
const BENT: f64 = 0.3;

/// See the module.
pub(super) const FORMS: &[Declaration] = &[
    TANH,
    Declaration { form: "tanh behind the servo", inputs: Declaration::NONE.inputs, surfaces: bend, ..TANH },
    Declaration {
        form: "table",
        parameters: |controls| {
            let of_each = |name: &String| {
                NODES_DEG.map(|node| Parameter::new(format!("dK_{name}_{node:.0}_deg"), -0.8..=0.8, 0.15))
            };
            with_power(controls.iter().flat_map(of_each).collect())
        },
        is_itself: bends,
        inputs: |p, place, inputs| {
            let faster = faster(p, place);
            for (control, added) in inputs.controls_rad.iter_mut().zip(p.chunks(NODES)) {
                for delta in control.iter_mut() {
                    *delta *= 1.0 + faster * between(added, delta.abs().to_degrees());
                }
            }
        },
        ..TANH
    },
];

const TANH: Declaration = Declaration {
    spec: Spec {
        name: "ctl_saturation",
        title: "control surfaces lose effectiveness at large deflections",
        side: Side::Control,
        rivals: &["act_rate", "ctl_scale", "ctl_asym"],
        experiment: "a static sweep of the flap; doublets of 5, 15 and 25 degrees",
    },
    form: "tanh",
    parameters: |controls| {
        let of_each = |name| Parameter::new(format!("inverse_s_{name}_per_rad"), 0.0..=8.0, 2.0);
        with_power(controls.iter().map(of_each).collect())
    },
    inputs: bend,
    excludes_deflection_correction: true,
    flight: Flight::Deflection,
    ..Declaration::NONE
};

/// Bends deflections, of commands or of surfaces.
fn bend(p: &[f64], place: &Place<'_>, deflections: &mut Inputs) {
    let faster = faster(p, place);
    for (control, inverse) in deflections.controls_rad.iter_mut().zip(p) {
        let inverse = inverse * faster;
        if inverse > 0.0 {
            for delta in control.iter_mut() {
                *delta = (inverse * *delta).tanh() / inverse;
            }
        }
    }
}

/// None without control surfaces.
fn with_power(mut of_each: Vec<Parameter>) -> Vec<Parameter> {
    if !of_each.is_empty() {
        of_each.push(Parameter::new("V_power", -1.0..=2.0, 0.3));
    }
    of_each
}

/// Whether a table is another at large deflections than at small ones.
fn bends(p: &[f64]) -> bool {
    let added = &p[..p.len() - 1];
    let largest = added.iter().map(|dk| dk.abs()).fold(0.0, f64::max);
    added.chunks(NODES).any(|dk| (dk[NODES - 1] - dk[0]).abs() > BENT * largest)
}

/// The loss at an airspeed over that at the reference airspeed.
fn faster(p: &[f64], place: &Place<'_>) -> f64 {
    let power = p[p.len() - 1];
    if place.flow.v_m_s > 0.0 { (place.flow.v_m_s / REFERENCE_V_M_S).powf(power) } else { 1.0 }
}

/// Straight between the nodes, constant outside.
fn between(added: &[f64], delta_deg: f64) -> f64 {
    let [low, middle, high] = NODES_DEG;
    if delta_deg <= middle {
        let t = ((delta_deg - low) / (middle - low)).max(0.0);
        added[0] + t * (added[1] - added[0])
    } else {
        let t = ((delta_deg - middle) / (high - middle)).min(1.0);
        added[1] + t * (added[2] - added[1])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_table_alike_at_all_deflections_is_no_saturation() {
        assert!(!bends(&[-0.27, -0.25, -0.26, -0.2, -0.2, -0.19, 0.0]));
        // more effective at small deflections, less at large ones
        assert!(bends(&[0.05, 0.1, -0.32, 0.0, 0.0, 0.0, 0.0]));
    }
}
