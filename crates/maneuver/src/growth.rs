//! Whether a model's motion grows by itself: above the flutter speed no time history means anything.

use crate::rig_model::RigModel;
use structure::unsymmetric::eigenvalues;

/// Real part over modulus of an eigenvalue that is called unstable: rounding is far below.
const GROWTH: f64 = 1e-6;

/// A motion of the model that grows by itself: the airspeed is above flutter.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Growing {
    /// Frequency; zero if it grows without swinging.
    pub frequency_hz: f64,
    /// Rate of growth, 1/s.
    pub growth_per_s: f64,
}

impl std::fmt::Display for Growing {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Self { frequency_hz, growth_per_s } = self;
        write!(
            f,
            "above the flutter speed: an oscillation of {frequency_hz:.2} Hz grows by exp({growth_per_s:.3} t)"
        )
    }
}

/// The fastest growing motion of a model; none below flutter.
pub fn growing(model: &RigModel) -> Option<Growing> {
    let values = eigenvalues(model.a.as_ref())?;
    let fastest = values.into_iter().max_by(|a, b| a.re.total_cmp(&b.re))?;
    (fastest.re > GROWTH * fastest.re.hypot(fastest.im))
        .then(|| Growing { frequency_hz: fastest.im.abs() / std::f64::consts::TAU, growth_per_s: fastest.re })
}
