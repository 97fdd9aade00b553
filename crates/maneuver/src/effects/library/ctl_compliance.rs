//! The linkage gives way under the hinge moment: the surface turns back in proportion to dynamic pressure.

use crate::effects::prelude::*;

/// Commands over what the surface does: it turns no further than five times its command.
const SMALLEST: f64 = 0.2;

/// See the module.
pub(super) const FORMS: &[Declaration] = &[Declaration {
    spec: Spec {
        name: "ctl_compliance",
        title: "the linkage gives way",
        side: Side::Control,
        rivals: &["ctl_scale", "tors_stiff"],
        experiment: "an airspeed sweep at one deflection; a potentiometer at the surface",
    },
    parameters: |_| vec![Parameter::new("k_at_30_m_s", -0.3..=2.0, 0.15)],
    known: |known, parameters| parameters[0].know(Calibration::Surfaces, known.to.linkage),
    inputs: |p, place, inputs| {
        // a linkage that turns the surface further must not turn it round
        let less = 1.0 / (1.0 + p[0] * place.q_over_reference()).max(SMALLEST);
        inputs.deflections().for_each(|delta| *delta *= less);
    },
    excludes_deflection_correction: true,
    flight: Flight::Deflection,
    ..Declaration::NONE
}];
