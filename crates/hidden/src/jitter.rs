//! The true wing of a case: that of the model with sections of its own, every parameter off by its own standard deviation.
//!
//! A model that is calibrated on static loads cannot know all of this: how the lift is spread within what six directions
//! an airspeed can say, what each flap does, how the wake's memory differs along the span, each mode's damping, the servo. So
//! a campaign without effects differs from the calibrated model by a few per cent of its variation.

use crate::physics::{Ends, Physics};
use crate::random::{Random, Stream};
use crate::servo::Servo;
use crate::strips::Strips;
use coupling::wing_file::{KnownTo, Servos};
use std::f64::consts::PI;

/// Relative standard deviations: bending and torsion stiffness, mass, lift slope, damping, apparent mass, rates and amplitudes
/// of the lags, effectiveness of a flap, frequency of the servo.
const BENDING: f64 = 0.01;
const TORSION: f64 = 0.02;
const MASS: f64 = 0.005;
const LIFT: f64 = 0.005;
const DAMPING: f64 = 0.05;
const DAMPING_OF_A_MODE: f64 = 0.15;
const APPARENT_MASS: f64 = 0.03;
const LAG_RATE: f64 = 0.05;
const LAG_AMPLITUDE: f64 = 0.05;
const FLAP: f64 = 0.01;
const SERVO: f64 = 0.03;
/// Waves of the lift along the span: half waves two to four.
const WAVE: f64 = 0.012;
/// Standard deviations in chords: place of the lift, of the flaps' loads, of the mass.
const CENTRE: f64 = 0.001;
const FLAP_AFT: f64 = 0.006;
const MASS_AFT: f64 = 0.003;
/// Offsets of lift and moment coefficient.
const LIFT_OFFSET: f64 = 0.002;
const MOMENT_OFFSET: f64 = 0.0005;

/// Number of jittered parameters.
const COUNT: usize = 30;
/// Place of the servo's frequency among them.
const SERVO_AT: usize = COUNT - 1;
/// Controls with jitter of their own.
const CONTROLS: usize = 3;

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

    /// What who analyses a campaign cannot know better, each off by one standard deviation: the jitter's, or the one that the wing's file
    /// states where that is more; and the servo's damping ratio, which only the file leaves open.
    pub(crate) fn nuisances(known_to: &KnownTo, servos: &Servos) -> Vec<(Self, Servo)> {
        let (frequency, damping_ratio_sd) = match *servos {
            Servos::SecondOrder { frequency_hz, frequency_sd_hz, damping_ratio_sd, .. } => {
                (frequency_sd_hz / frequency_hz, damping_ratio_sd)
            }
            Servos::None => (0.0, 0.0),
        };
        let stated = |parameter: usize| match parameter {
            0 => known_to.bending / BENDING,
            2 => known_to.torsion / TORSION,
            4 => known_to.mass / MASS,
            6 => known_to.damping / DAMPING,
            12 => known_to.apparent_mass / APPARENT_MASS,
            13 => known_to.wake_lag / LAG_RATE,
            14..17 => known_to.surfaces / FLAP,
            SERVO_AT => frequency / SERVO,
            _ => 1.0,
        };
        let off = |parameter: usize| {
            let mut jitter = Self::none();
            jitter.0[parameter] = stated(parameter).max(1.0);
            (jitter, jitter.servo())
        };
        let servo = Self::none().servo();
        let damped = Servo { damping_ratio: servo.damping_ratio + damping_ratio_sd, ..servo };
        (0..COUNT).map(off).chain([(Self::none(), damped)]).collect()
    }

    /// Changes a neutral wing: sections first, then jitter.
    pub(crate) fn apply(&self, strips: &Strips, v_m_s: f64, physics: &mut Physics) {
        self.apply_to_structure(physics);
        self.apply_to_strips(strips, v_m_s, physics);
        let j = &self.0;
        for rate in &mut physics.lag_rate {
            *rate *= 1.0 + LAG_RATE * j[13];
        }
        for (control, flap) in physics.flap.iter_mut().enumerate() {
            let own = control.min(CONTROLS - 1);
            *flap *= FLAP_FACTOR[own] * (1.0 + FLAP * j[14 + own]);
            physics.flap_aft_over_c[control] = FLAP_AFT * j[17 + own];
        }
    }

    fn apply_to_structure(&self, physics: &mut Physics) {
        let j = &self.0;
        physics.bending = Ends { root: BENDING * (j[0] + 0.7 * j[1]), tip: BENDING * (j[0] - 0.7 * j[1]) };
        physics.torsion = Ends { root: TORSION * (j[2] + 0.7 * j[3]), tip: TORSION * (j[2] - 0.7 * j[3]) };
        physics.mass = Ends { root: MASS * (j[4] + j[5]), tip: MASS * (j[4] - j[5]) };
        physics.mass_aft_over_c = MASS_AFT * j[20];
        for (mode, zeta) in physics.damping.iter_mut().enumerate() {
            // modes two and three have a jitter of their own, the others follow the first
            let own = if mode == 1 || mode == 2 { DAMPING_OF_A_MODE * j[20 + mode] } else { 0.0 };
            *zeta *= 1.0 + DAMPING * j[6] + own;
        }
    }

    fn apply_to_strips(&self, strips: &Strips, v_m_s: f64, physics: &mut Physics) {
        let j = &self.0;
        for strip in 0..strips.len() {
            let eta = strips.eta[strip];
            let outward = 2.0 * eta - 1.0;
            let waves: f64 =
                (0..3).map(|wave| WAVE * j[23 + wave] * (PI * (wave + 2) as f64 * eta).cos()).sum();
            physics.lift[strip] = section_lift(eta) * (1.0 + LIFT * (j[7] + j[8] * outward) + waves);
            physics.centre_aft_over_c[strip] = section_centre(eta) + CENTRE * j[9];
            physics.lift_offset[strip] = section_offset(v_m_s) + LIFT_OFFSET * j[10];
            physics.moment_offset[strip] = -0.2 * section_offset(v_m_s) + MOMENT_OFFSET * j[11];
            physics.apparent_mass[strip] = 1.0 + APPARENT_MASS * (j[12] + j[26] * outward);
            physics.lag_amplitude[strip] =
                LAG_OF_SECTIONS * (1.0 + LAG_AMPLITUDE * (j[27] + j[28] * outward));
        }
    }

    /// The servo: about as late as the assumed one of 15 Hz and 0.8, with another shape.
    pub(crate) fn servo(&self) -> Servo {
        Servo { frequency_hz: 14.2 * (1.0 + SERVO * self.0[SERVO_AT]), damping_ratio: 0.76 }
    }
}

/// Flaps have a little less effect than in potential flow beside what their strips lose.
const FLAP_FACTOR: [f64; CONTROLS] = [0.99, 0.985, 1.0];

/// The boundary layer takes a little of the wake's memory.
const LAG_OF_SECTIONS: f64 = 0.97;

/// Sections lift less than flat plates, most near the tip.
fn section_lift(eta: f64) -> f64 {
    0.975 - 0.06 * eta.powi(3) + 0.02 * (PI * 3.0 * eta).sin()
}

/// Their lift acts ahead of or behind the quarter point.
fn section_centre(eta: f64) -> f64 {
    -0.004 + 0.004 * eta
}

/// The boundary layer's decambering, less with airspeed.
fn section_offset(v_m_s: f64) -> f64 {
    -0.03 * (30.0 / v_m_s.max(10.0)).sqrt()
}
