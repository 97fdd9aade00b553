//! A mass on the wing that the model lacks: a pod, a servo, a cable. It stands near the tip, so far inboard and so far aft of the
//! quarter chord as its other parameters say.

use crate::effects::prelude::*;

/// Where the mass is without its second parameter, over the span.
const OUTERMOST: f64 = 0.97;

/// See the module.
pub(super) const FORMS: &[Declaration] = &[Declaration {
    spec: Spec {
        name: "tip_mass",
        title: "unmodelled mass on the outer wing",
        side: Side::Structure,
        rivals: &["bend_stiff", "wing_mass_error"],
        experiment: "wind-off pitch: mass changes it, stiffness alone does not change the static deflection",
    },
    parameters: |_| {
        vec![
            Parameter::new("m_kg", 0.0..=0.4, 0.05),
            Parameter::new("inboard_over_L", 0.0..=0.5, 0.1),
            Parameter::new("aft_over_c", -0.5..=0.7, 0.2),
        ]
    },
    // without mass its place says nothing, and a small one is not where a large one would be
    starts: &[&[0.05, 0.05, 0.2], &[0.05, 0.25, 0.2], &[0.015, 0.05, 0.3]],
    change: |p, _, change| {
        if p[0] != 0.0 {
            change.points.push(PointMass { mass_kg: p[0], y_norm: OUTERMOST - p[1], aft_over_c: p[2] });
        }
    },
    ..Declaration::NONE
}];
