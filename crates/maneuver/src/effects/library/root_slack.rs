//! Freeplay at the root joint: the first mode meets no stiffness within a gap of the tip.

use crate::effects::prelude::*;

/// Share of the stiffness that is lost within the gap: all of it would leave no shape at rest.
const SOFT: f64 = 0.5;

/// See the module.
pub(super) const FORMS: &[Declaration] = &[Declaration {
    spec: Spec {
        name: "root_slack",
        title: "freeplay or slack at the root joint",
        side: Side::Structure,
        rivals: &["backlash", "bend_stiff"],
        experiment: "small amplitudes without wind",
    },
    parameters: |_| vec![Parameter::new("gap_m", 0.0..=0.05, 0.01)],
    needs_zones: true,
    forces: |p, place, state, forces| {
        // inside the gap all of the force is missing, outside what the gap takes off
        let missing = |z: f64| z.clamp(-0.5 * p[0], 0.5 * p[0]);
        forces.push_first_mode(place, state, |z| SOFT * place.first_stiffness * missing(z));
    },
    ..Declaration::NONE
}];
