//! Play in the linkage of the control surfaces: between the servo, whose overshoot takes some of it up, and the surface.

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
        vec![Parameter::new("gap_deg", (0.0, 3.0), 1.0)]
    }

    fn inputs(&self, p: &[f64], place: &Place<'_>, inputs: &mut Inputs) {
        if !place.steady && p[0] > 0.0 {
            let servo = (place.actuator.frequency_hz, place.actuator.damping_ratio);
            for control in &mut inputs.controls_rad {
                let turned = signal::damped(control, place.time_step_s, servo);
                let surface = signal::play(&turned, p[0].to_radians());
                // the command to which a surface without play would answer so, but for the servo's lag of the difference
                for (command, (after, before)) in control.iter_mut().zip(surface.iter().zip(&turned)) {
                    *command += after - before;
                }
            }
        }
    }
}
