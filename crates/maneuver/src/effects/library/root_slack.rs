//! Freeplay at the root joint: the first mode meets less stiffness within a gap of the tip.
//!
//! Two forms: with an edge at the ends of the gap, or `smooth`, where surfaces that are not quite flat close little by little.

use crate::effects::prelude::*;

/// Share of the stiffness that is lost within the gap: all of it would leave no shape at rest.
const SOFT: f64 = 0.5;

/// See the module.
pub(super) const FORMS: &[Declaration] = &[
    EDGED,
    Declaration {
        form: "smooth",
        forces: |p, place, state, forces| {
            let half = 0.5 * p[0];
            slacken(place, state, forces, |z| if half > 0.0 { half * (z / half).tanh() } else { 0.0 });
        },
        ..EDGED
    },
];

const EDGED: Declaration = Declaration {
    spec: Spec {
        name: "root_slack",
        title: "freeplay or slack at the root joint",
        side: Side::Structure,
        rivals: &["backlash", "bend_stiff"],
        experiment: "small amplitudes without wind",
    },
    parameters: |_| vec![Parameter::new("gap_m", 0.0..=0.05, 0.01)],
    needs: Needs::OUTER_HEIGHT,
    forces: |p, place, state, forces| {
        // inside the gap all of the force is missing, outside what the gap takes off
        slacken(place, state, forces, |z| z.clamp(-0.5 * p[0], 0.5 * p[0]));
    },
    ..Declaration::NONE
};

/// Takes off the share of the stiffness times the height that is missing (m) of a height (m).
fn slacken(place: &Place<'_>, state: &WingState<'_>, forces: &mut Forces, missing: impl Fn(f64) -> f64) {
    forces.push_first_mode(place, state, |z| SOFT * place.first_stiffness * missing(z));
}
