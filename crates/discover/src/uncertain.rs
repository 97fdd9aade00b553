//! What a calibrated model knows only so well, as effects of a size within their standard deviation: parameters of the
//! structure, the air and the servos, how the lift lies along the span (root loads do not see it), and what each control
//! surface does for itself.

use crate::rules::SharedRules;
use maneuver::effects::{Active, Effect, Inputs, Parameter, Place, Side, Spec};
use maneuver::rom::Change;
use std::f64::consts::PI;
use std::sync::Arc;

/// Everything that is uncertain, each at one standard deviation: what a calibration leaves of the library's effects, in the
/// order of its tests; waves of the lift; control surfaces. The first of an effect's forms counts.
pub fn uncertain(library: &[Arc<dyn Effect>], controls: &[String], rules: &SharedRules) -> Vec<Active> {
    let mut calibrated = Vec::new();
    for (i, effect) in library.iter().enumerate() {
        if i > 0 && library[i - 1].spec().name == effect.spec().name {
            continue;
        }
        let parameters = effect.parameters();
        for (k, known) in parameters.iter().enumerate().filter_map(|(k, p)| Some((k, p.calibrated?))) {
            let mut values = vec![0.0; parameters.len()];
            values[k] = known.sigma;
            calibrated.push((known.by, Active::new(Arc::clone(effect), &values)));
        }
    }
    calibrated.sort_by_key(|(by, _)| *by);
    let calibrated = calibrated.into_iter().map(|(_, active)| active);
    let waves = rules.half_waves.map(|half_waves| {
        let sigma = rules.lift_wave;
        Active::new(Arc::new(Wave { half_waves, sigma }), &[sigma])
    });
    let sigma = rules.surface;
    let surface = |control| Active::new(Arc::new(Surface { control, sigma }), &[sigma]);
    calibrated.chain(waves).chain((0..controls.len()).map(surface)).collect()
}

/// A wave of the lift along the span.
#[derive(Debug)]
struct Wave {
    half_waves: u8,
    sigma: f64,
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
        vec![Parameter::new("share", -1.0..=1.0, self.sigma)]
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
    sigma: f64,
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
        vec![Parameter::new("share", -1.0..=1.0, self.sigma)]
    }

    fn inputs(&self, p: &[f64], _place: &Place<'_>, inputs: &mut Inputs) {
        inputs.controls_rad[self.control].iter_mut().for_each(|delta| *delta += p[0] * *delta);
    }
}
