//! Experiments that may be asked for: what moves, and what they cost beside each other.

use crate::data::RATE_HZ;
use maneuver::Smooth;
use maneuver::effects::{Inputs, Stimulus};
use std::f64::consts::TAU;

/// Angle at which runs begin, rad.
const BASE_RAD: f64 = 0.02;
/// Rest before a motion, s.
const REST_S: f64 = 0.5;

/// One entry.
#[derive(Debug, Clone)]
pub struct Experiment {
    /// What to fly.
    pub name: &'static str,
    /// Effort: one is a run with wind.
    pub cost: f64,
    /// Airspeed and motion of every run; airspeeds as shares of the campaign's largest.
    pub(crate) runs: Vec<(f64, Move)>,
}

/// What moves in a run.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Move {
    /// One minus cosine of the angle: height in rad, Hz.
    Pitch(f64, f64),
    /// Up and down slowly between two angles, rad.
    Triangle(f64, f64),
    /// A surface up and down slowly to both sides, rad.
    SurfaceTriangle(f64),
    /// A surface swings with a rising frequency: amplitude in rad, to Hz.
    Chirp(f64, f64),
    /// Static points between two angles, rad.
    Sweep(f64, f64),
}

/// All entries.
pub fn menu() -> Vec<Experiment> {
    let wind_off = 0.0;
    vec![
        Experiment {
            name: "wind-off pitch at 2, 4 and 6 Hz",
            cost: 1.5,
            runs: [2.0, 4.0, 6.0].map(|hz| (wind_off, Move::Pitch(0.09, hz))).to_vec(),
        },
        Experiment {
            name: "a wind-off tilt from -6 to 12 degrees",
            cost: 0.5,
            runs: vec![(0.0, Move::Sweep(-0.1, 0.21))],
        },
        Experiment { name: "pitch at 8 Hz", cost: 1.0, runs: vec![(0.75, Move::Pitch(0.07, 8.0))] },
        Experiment {
            name: "a slow triangle of pitch, up and down",
            cost: 1.0,
            runs: vec![(0.75, Move::Triangle(-0.07, 0.14))],
        },
        Experiment {
            name: "a slow triangle of a control surface",
            cost: 1.0,
            runs: vec![(0.75, Move::SurfaceTriangle(0.44))],
        },
        Experiment {
            name: "a chirp of a control surface to 12 Hz at small amplitude",
            cost: 1.5,
            runs: vec![(1.0, Move::Chirp(0.035, 12.0))],
        },
        Experiment {
            name: "a wide sweep of angles, -8 to 14 degrees",
            cost: 2.0,
            runs: vec![(0.6, Move::Sweep(-0.14, 0.24)), (1.0, Move::Sweep(-0.14, 0.24))],
        },
        Experiment {
            name: "another airspeed, a fifth faster: a sweep, pitch at 2 Hz and a chirp",
            cost: 3.0,
            runs: vec![
                (1.2, Move::Sweep(-0.07, 0.14)),
                (1.2, Move::Pitch(0.09, 2.0)),
                (1.2, Move::Chirp(0.07, 10.0)),
            ],
        },
    ]
}

impl Move {
    /// Whether its samples are static points.
    pub(crate) fn is_static(self) -> bool {
        matches!(self, Self::Sweep(..))
    }

    /// As something that drives a wing; surfaces move where there are any.
    pub(crate) fn stimulus(self, controls: usize) -> Stimulus {
        let (alpha, surface) = self.signals();
        let samples = alpha.value.len();
        let still = vec![0.0; samples];
        let moved = |k: usize| if k + 1 == controls { surface.clone() } else { still.clone() };
        Stimulus {
            inputs: Inputs {
                incidence_rad: still.clone(),
                controls_rad: (0..controls).map(moved).collect(),
                alpha,
            },
            time_step_s: 1.0 / RATE_HZ,
            steady: self.is_static(),
            clock_h: 0.0,
        }
    }

    fn signals(self) -> (Smooth, Vec<f64>) {
        let dt = 1.0 / RATE_HZ;
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "some seconds of samples"
        )]
        let times = |length_s: f64| {
            (0..(length_s * RATE_HZ) as usize).map(|i| i as f64 * dt - REST_S).collect::<Vec<f64>>()
        };
        let held = |n: usize| Smooth { value: vec![BASE_RAD; n], rate: vec![0.0; n], second: vec![0.0; n] };
        match self {
            Self::Pitch(height, hz) => {
                let w = TAU * hz;
                let t = times(REST_S + 1.0 / hz + 1.0);
                let inside = |t: f64| f64::from(u8::from(t > 0.0 && t < 1.0 / hz));
                let of = |f: &dyn Fn(f64) -> f64| t.iter().map(|t| inside(*t) * f(*t)).collect::<Vec<f64>>();
                let value =
                    of(&|t| 0.5 * height * (1.0 - (w * t).cos())).iter().map(|v| BASE_RAD + v).collect();
                let rate = of(&|t| 0.5 * height * w * (w * t).sin());
                let second = of(&|t| 0.5 * height * w * w * (w * t).cos());
                (Smooth { value, rate, second }, vec![0.0; t.len()])
            }
            Self::Triangle(low, high) => {
                let t = times(REST_S + 12.0);
                let value: Vec<f64> = t.iter().map(|t| low + (high - low) * triangle(t / 12.0)).collect();
                let slope = |t: &f64| 2.0 * (high - low) / 12.0 * if *t < 6.0 { 1.0 } else { -1.0 };
                let rate = t.iter().map(|t| if *t > 0.0 { slope(t) } else { 0.0 }).collect();
                let n = t.len();
                (Smooth { value, rate, second: vec![0.0; n] }, vec![0.0; n])
            }
            Self::SurfaceTriangle(most) => {
                let t = times(REST_S + 12.0);
                let surface =
                    t.iter().map(|t| most * (triangle(t / 6.0) - triangle(t / 6.0 - 1.0))).collect();
                (held(t.len()), surface)
            }
            Self::Chirp(most, to_hz) => {
                let length_s = 15.0;
                let t = times(REST_S + length_s + 1.0);
                let phase = |t: f64| 0.5 * TAU * to_hz * t * t / length_s;
                let inside = |t: f64| t > 0.0 && t < length_s;
                let surface =
                    t.iter().map(|t| if inside(*t) { most * phase(*t).sin() } else { 0.0 }).collect();
                (held(t.len()), surface)
            }
            Self::Sweep(from, to) => {
                let count = 9;
                let value =
                    (0..count).map(|i| from + (to - from) * f64::from(i) / f64::from(count - 1)).collect();
                let still = vec![0.0; 9];
                (Smooth { value, rate: still.clone(), second: still.clone() }, still)
            }
        }
    }
}

/// From zero to one and back over one unit, zero outside.
fn triangle(x: f64) -> f64 {
    if (0.0..1.0).contains(&x) { 1.0 - (2.0 * x - 1.0).abs() } else { 0.0 }
}
