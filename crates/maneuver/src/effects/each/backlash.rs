//! Play in the linkage of the control surfaces.

use super::prelude::*;

/// See the module.
#[derive(Debug)]
pub(crate) struct Backlash;

impl Effect for Backlash {
    fn spec(&self) -> &'static Spec {
        &Spec {
            name: "backlash",
            title: "play in the linkage",
            side: Side::Control,
            rivals: &["ctl_scale", "ctl_saturation"],
            experiment: "amplitudes from 1 to 5 degrees; a slow triangle",
        }
    }

    fn parameters(&self) -> Vec<Parameter> {
        vec![Parameter::new("gap_deg", (0.0, 4.0), 1.0)]
    }

    fn inputs(&self, p: &[f64], place: &Place<'_>, inputs: &mut Inputs) {
        if !place.steady && p[0] > 0.0 {
            for control in &mut inputs.controls_rad {
                *control = signal::play(control, p[0].to_radians());
            }
        }
    }
}
