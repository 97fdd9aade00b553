//! What a calibrated model knows only so well, as effects of a size within their standard deviation: parameters of the
//! structure, the air and the servos, how the lift lies along the span (root loads do not see it), and what each control
//! surface does for itself.

use maneuver::effects::{Active, Effect, Inputs, Parameter, Place, Side, Spec};
use maneuver::rom::Change;
use std::f64::consts::PI;
use std::sync::Arc;

/// Effect of the library, which of its parameters, standard deviation. The first of an effect's forms counts.
const KNOWN: [(&str, usize, f64); 11] = [
    ("bend_stiff", 0, 0.01),
    ("tors_stiff", 0, 0.02),
    ("wing_mass_error", 0, 0.007),
    ("damping", 0, 0.1),
    ("added_mass", 0, 0.04),
    ("aero_lag", 0, 0.07),
    ("ctl_scale", 0, 0.01),
    ("ctl_compliance", 0, 0.01),
    ("act_lag", 0, 0.001),
    ("alpha_offset", 0, 0.01),
    ("delay", 0, 0.001),
];

/// How many of these standard deviations an effect must have before it is more than a matter of calibration.
pub const PRIOR_WIDTHS: f64 = 2.5;
/// Standard deviation of each wave of the lift along the span.
const WAVE: f64 = 0.015;
/// Half waves of the first and the last: those that the corrections' directions do not hold.
const HALF_WAVES: [u8; 3] = [2, 3, 4];
/// Standard deviation of a single control surface's effectiveness.
const SURFACE: f64 = 0.015;

/// Standard deviation of a parameter that calibration knows.
pub fn known(effect: &str, parameter: usize) -> Option<f64> {
    KNOWN.iter().find(|(name, which, _)| *name == effect && *which == parameter).map(|u| u.2)
}

/// Everything that is uncertain, each at one standard deviation.
pub fn uncertain(library: &[Arc<dyn Effect>], controls: &[String]) -> Vec<Active> {
    let known = KNOWN.iter().filter_map(|(name, parameter, sigma)| {
        let effect = library.iter().find(|effect| effect.spec().name == *name)?;
        let mut values = vec![0.0; effect.parameters().len()];
        values[*parameter] = *sigma;
        Some(Active::new(Arc::clone(effect), &values))
    });
    let waves = HALF_WAVES.map(|half_waves| Active::new(Arc::new(Wave { half_waves }), &[WAVE]));
    let surface = |control| Active::new(Arc::new(Surface { control }), &[SURFACE]);
    known.chain(waves).chain((0..controls.len()).map(surface)).collect()
}

/// A wave of the lift along the span.
#[derive(Debug)]
struct Wave {
    half_waves: u8,
}

impl Effect for Wave {
    fn spec(&self) -> &'static Spec {
        &Spec {
            name: "lift_wave",
            title: "the lift's place along the span",
            side: Side::Aerodynamics,
            rivals: &[],
            experiment: "",
        }
    }

    fn parameters(&self) -> Vec<Parameter> {
        vec![Parameter::new("share", (-1.0, 1.0), WAVE)]
    }

    fn change(&self, p: &[f64], place: &Place<'_>, change: &mut Change) {
        for (factor, y) in change.zone_force.iter_mut().zip(&place.zones.y_norm) {
            *factor += p[0] * (PI * f64::from(self.half_waves) * y).cos();
        }
    }
}

/// The effectiveness of one control surface.
#[derive(Debug)]
struct Surface {
    control: usize,
}

impl Effect for Surface {
    fn spec(&self) -> &'static Spec {
        &Spec {
            name: "surface",
            title: "effectiveness of one surface",
            side: Side::Control,
            rivals: &[],
            experiment: "",
        }
    }

    fn parameters(&self) -> Vec<Parameter> {
        vec![Parameter::new("share", (-1.0, 1.0), SURFACE)]
    }

    fn inputs(&self, p: &[f64], _place: &Place<'_>, inputs: &mut Inputs) {
        inputs.controls_rad[self.control].iter_mut().for_each(|delta| *delta += p[0] * *delta);
    }
}
