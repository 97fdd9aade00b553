//! Control surfaces are rigged a little off, all by one angle.

use crate::effects::prelude::*;

/// See the module.
pub(super) const FORMS: &[Declaration] = &[Declaration {
    spec: Spec {
        name: "delta_offset",
        title: "control surfaces are rigged off zero",
        side: Side::Control,
        rivals: &["camber", "alpha_offset"],
        experiment: "a check of every surface's zero",
    },
    parameters: |_| vec![Parameter::new("d0_deg", -5.0..=5.0, 1.0)],
    inputs: |p, place, inputs| {
        if place.flow.v_m_s > 0.0 {
            inputs.deflections().for_each(|delta| *delta += p[0].to_radians());
        }
    },
    ..Declaration::NONE
}];
