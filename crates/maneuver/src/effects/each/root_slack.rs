//! Play at the root joint: the first mode meets no stiffness within a gap of the tip.

use super::prelude::*;

/// Share of the stiffness that is lost within the gap: all of it would leave no shape at rest.
const SOFT: f64 = 0.5;

/// See the module.
#[derive(Debug)]
pub(crate) struct RootSlack;

impl Effect for RootSlack {
    fn spec(&self) -> &'static Spec {
        &Spec {
            name: "root_slack",
            title: "play or slack at the root joint",
            side: Side::Structure,
            rivals: &["backlash", "bend_stiff"],
            experiment: "small amplitudes without wind",
        }
    }

    fn parameters(&self) -> Vec<Parameter> {
        vec![Parameter::new("gap_m", (0.0, 0.05), 0.01)]
    }

    fn needs_zones(&self) -> bool {
        true
    }

    fn forces(&self, p: &[f64], place: &Place<'_>, seen: &Seen<'_>, forces: &mut Forces) {
        let Some(outer) = seen.height_m.last() else { return };
        let shape = place.outer_shape;
        if shape == 0.0 || p[0] == 0.0 {
            return;
        }
        for (modal, z) in forces.modal[0].iter_mut().zip(outer) {
            // inside the gap all of the force is missing, outside what the gap takes off
            let missing = z.clamp(-0.5 * p[0], 0.5 * p[0]);
            *modal += SOFT * place.first_stiffness * missing / shape;
        }
    }
}
