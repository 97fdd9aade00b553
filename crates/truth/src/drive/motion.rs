//! Motions, with their own derivatives where they have any.

use serde::Deserialize;
use std::f64::consts::TAU;

/// A motion of the angle of attack (`of: "alpha"`) or of a control surface, degrees and seconds as in maneuver files.
#[derive(Debug, Clone, PartialEq, Deserialize)]
pub enum Motion {
    /// Up and back once, smoothly.
    OneMinusCosine {
        /// What moves.
        of: String,
        /// Height, degrees.
        height_deg: f64,
        /// One over its length, Hz.
        frequency_hz: f64,
        /// Beginning, s.
        #[serde(default)]
        start_s: f64,
    },
    /// Half its length up, half down.
    Doublet {
        /// What moves.
        of: String,
        /// Height of each half, degrees.
        height_deg: f64,
        /// One over its length, Hz.
        frequency_hz: f64,
        /// Beginning, s.
        #[serde(default)]
        start_s: f64,
    },
    /// A sine whose frequency runs linearly.
    Chirp {
        /// What moves.
        of: String,
        /// Amplitude, degrees.
        height_deg: f64,
        /// First frequency, Hz.
        from_hz: f64,
        /// Last frequency, Hz.
        to_hz: f64,
        /// Length, s.
        duration_s: f64,
        /// Beginning, s.
        #[serde(default)]
        start_s: f64,
    },
    /// To a height, where it stays.
    Step {
        /// What moves.
        of: String,
        /// Height, degrees.
        height_deg: f64,
        /// Beginning, s.
        #[serde(default)]
        start_s: f64,
    },
}

impl Motion {
    /// What moves.
    pub fn of(&self) -> &str {
        match self {
            Self::OneMinusCosine { of, .. }
            | Self::Doublet { of, .. }
            | Self::Chirp { of, .. }
            | Self::Step { of, .. } => of,
        }
    }

    /// Value, rate and second derivative at a time: degrees, s. Jumps have no derivatives.
    pub fn at(&self, t_s: f64) -> [f64; 3] {
        match self {
            Self::OneMinusCosine { height_deg, frequency_hz, start_s, .. } => {
                let (t, omega) = (t_s - start_s, TAU * frequency_hz);
                if !(0.0..=1.0).contains(&(t * frequency_hz)) {
                    return [0.0; 3];
                }
                let (sin, cos) = (omega * t).sin_cos();
                [1.0 - cos, omega * sin, omega * omega * cos].map(|value| 0.5 * height_deg * value)
            }
            Self::Doublet { height_deg, frequency_hz, start_s, .. } => {
                // a time that is meant to be the edge belongs to what begins there
                let share = (t_s - start_s) * frequency_hz + 1e-9;
                let side = if (0.0..0.5).contains(&share) {
                    1.0
                } else if (0.5..1.0).contains(&share) {
                    -1.0
                } else {
                    0.0
                };
                [side * height_deg, 0.0, 0.0]
            }
            Self::Chirp { height_deg, from_hz, to_hz, duration_s, start_s, .. } => {
                let t = t_s - start_s;
                if !(0.0..=*duration_s).contains(&t) {
                    return [0.0; 3];
                }
                let growth = TAU * (to_hz - from_hz) / duration_s;
                let (phase, omega) = (TAU * from_hz * t + 0.5 * growth * t * t, TAU * from_hz + growth * t);
                let (sin, cos) = phase.sin_cos();
                [sin, omega * cos, growth * cos - omega * omega * sin].map(|value| height_deg * value)
            }
            Self::Step { height_deg, start_s, .. } => {
                [if t_s + 1e-9 >= *start_s { *height_deg } else { 0.0 }, 0.0, 0.0]
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Motion;

    #[test]
    fn derivatives_are_those_of_the_motion() {
        let of = || "alpha".to_owned();
        let pitch = Motion::OneMinusCosine { of: of(), height_deg: 5.0, frequency_hz: 2.0, start_s: 0.5 };
        let chirp = Motion::Chirp {
            of: of(),
            height_deg: 4.0,
            from_hz: 1.0,
            to_hz: 10.0,
            duration_s: 9.0,
            start_s: 0.1,
        };
        for motion in [pitch, chirp] {
            let h = 1e-5;
            for t_s in [0.6, 0.71, 0.93] {
                let [before, now, after] = [t_s - h, t_s, t_s + h].map(|t| motion.at(t));
                assert!((now[1] - (after[0] - before[0]) / (2.0 * h)).abs() < 1e-4 * (1.0 + now[1].abs()));
                assert!((now[2] - (after[1] - before[1]) / (2.0 * h)).abs() < 1e-4 * (1.0 + now[2].abs()));
            }
        }
    }
}
