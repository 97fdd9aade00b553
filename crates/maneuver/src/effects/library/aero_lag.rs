//! The wake remembers longer or shorter than the doublet lattice says; the other form: all that is unsteady is larger or smaller,
//! too (paper 1's outlook: a correction that depends on frequency, causal, with the steady limit as it is).

use crate::effects::prelude::*;

/// See the module.
pub(super) const FORMS: &[Declaration] = &[
    LAG,
    Declaration {
        form: "gain and lag",
        parameters: |_| vec![lag_share(), Parameter::new("dgain", -0.95..=3.0, 0.3)],
        known: |known, parameters| {
            for parameter in parameters {
                parameter.know(Calibration::Air, known.to.wake_lag);
            }
        },
        change: |p, _, change| {
            change.lag += p[0];
            change.unsteady += p[1];
        },
        ..LAG
    },
];

fn lag_share() -> Parameter {
    Parameter::new("dlag", -0.8..=5.0, 0.5)
}

const LAG: Declaration = Declaration {
    spec: Spec {
        name: "aero_lag",
        title: "lag of the wake",
        side: Side::Aerodynamics,
        rivals: &["delay", "act_lag", "added_mass"],
        experiment: "a frequency sweep at two airspeeds: it collapses on reduced frequency",
    },
    form: "lag",
    parameters: |_| vec![lag_share()],
    known: |known, parameters| parameters[0].know(Calibration::Air, known.to.wake_lag),
    change: |p, _, change| change.lag += p[0],
    ..Declaration::NONE
};
