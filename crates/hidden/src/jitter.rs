//! The true wing of a case: that of the model with sections of its own, every parameter off by its own standard deviation.

use crate::physics::{Ends, Physics};
use crate::random::{Random, Stream};
use crate::servo::Servo;
use crate::strips::Strips;

/// Relative standard deviations: bending and torsion stiffness, mass, lift slope, damping, apparent mass, rates of the
/// lags, effectiveness of a flap, frequency of the servo.
const BENDING: f64 = 0.01;
const TORSION: f64 = 0.02;
const MASS: f64 = 0.005;
const LIFT: f64 = 0.005;
const DAMPING: f64 = 0.05;
const APPARENT_MASS: f64 = 0.03;
const LAG_RATE: f64 = 0.05;
const FLAP: f64 = 0.01;
const SERVO: f64 = 0.02;
/// Standard deviations: place of the lift (chords), offsets of lift and moment coefficient.
const CENTRE: f64 = 0.001;
const LIFT_OFFSET: f64 = 0.002;
const MOMENT_OFFSET: f64 = 0.0005;

/// Number of jittered parameters.
pub(crate) const COUNT: usize = 16;

/// Jitter in standard deviations, one a parameter.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Jitter(pub(crate) [f64; COUNT]);

impl Jitter {
    /// None: the wing in the middle of all others.
    pub fn none() -> Self {
        Self([0.0; COUNT])
    }

    /// That of a case, not beyond two and a half standard deviations.
    pub(crate) fn of(seed: u64) -> Self {
        let mut random = Random::new(seed, Stream::Jitter);
        Self(std::array::from_fn(|_| random.normal(1.0).clamp(-2.5, 2.5)))
    }

    /// One parameter off by one standard deviation.
    pub(crate) fn unit(parameter: usize) -> Self {
        Self(std::array::from_fn(|i| if i == parameter { 1.0 } else { 0.0 }))
    }

    /// Changes a neutral wing: sections first, then jitter.
    pub(crate) fn apply(&self, strips: &Strips, v_m_s: f64, physics: &mut Physics) {
        let j = &self.0;
        physics.bending = Ends { root: BENDING * (j[0] + 0.5 * j[1]), tip: BENDING * (j[0] - 0.5 * j[1]) };
        physics.torsion = Ends { root: TORSION * (j[2] + 0.5 * j[3]), tip: TORSION * (j[2] - 0.5 * j[3]) };
        physics.mass = Ends { root: MASS * (j[4] + j[5]), tip: MASS * (j[4] - j[5]) };
        for zeta in &mut physics.damping {
            *zeta *= 1.0 + DAMPING * j[6];
        }
        for strip in 0..strips.len() {
            let eta = strips.eta[strip];
            physics.lift[strip] = section_lift(eta) * (1.0 + LIFT * (j[7] + j[8] * (2.0 * eta - 1.0)));
            physics.centre_aft_over_c[strip] = section_centre(eta) + CENTRE * j[9];
            physics.lift_offset[strip] = section_offset(v_m_s) + LIFT_OFFSET * j[10];
            physics.moment_offset[strip] = -0.2 * section_offset(v_m_s) + MOMENT_OFFSET * j[11];
            physics.apparent_mass[strip] = 1.0 + APPARENT_MASS * j[12];
        }
        for rate in &mut physics.lag_rate {
            *rate *= 1.0 + LAG_RATE * j[13];
        }
        let inner_first = 1.0 / physics.flap.len().max(1) as f64;
        for (control, flap) in physics.flap.iter_mut().enumerate() {
            let outward = (control as f64 + 0.5) * inner_first - 0.5;
            *flap *= FLAP_FACTOR * (1.0 + FLAP * (j[14] + outward * j[8]));
        }
    }

    /// The servo.
    pub(crate) fn servo(&self) -> Servo {
        Servo { frequency_hz: 15.0 * (1.0 + SERVO * self.0[15]), damping_ratio: 0.8 }
    }
}

/// A flap has a little less effect than in potential flow beside what its strips lose.
const FLAP_FACTOR: f64 = 0.985;

/// Sections lift less than flat plates, most near the tip.
fn section_lift(eta: f64) -> f64 {
    0.955 - 0.04 * eta.powi(3)
}

/// Their lift acts ahead of or behind the quarter point.
fn section_centre(eta: f64) -> f64 {
    -0.004 + 0.004 * eta
}

/// The boundary layer's decambering, less with airspeed.
fn section_offset(v_m_s: f64) -> f64 {
    -0.03 * (30.0 / v_m_s.max(10.0)).sqrt()
}
