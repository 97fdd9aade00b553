//! Experiments that may be asked for: what moves, and what they cost beside each other.

use crate::rules::{ExperimentRules, Rules};
use maneuver::Smooth;
use maneuver::effects::{Inputs, Stimulus};
use maneuver::motion::{Chirp, OneMinusCosine, Shape, Triangle};

/// One entry.
#[derive(Debug, Clone)]
pub struct Experiment {
    /// What to fly.
    pub name: &'static str,
    /// Effort: one is a run with wind.
    pub cost: f64,
    /// Airspeed and motion of every run; airspeeds as shares of the campaign's largest.
    pub(crate) runs: Vec<(f64, Planned)>,
}

/// What is flown in a run; angles in rad.
#[derive(Debug, Clone)]
pub(crate) enum Planned {
    /// A motion of the angle of attack, or of the outermost surface, if there is one.
    Motion {
        /// Angle of attack at the beginning.
        angle: f64,
        /// Whether the surface moves, not the angle.
        of_surface: bool,
        /// How it moves.
        shape: Shape,
        /// Rest after it, s.
        after_s: f64,
    },
    /// Static points between two angles.
    Points(f64, f64),
}

/// One-minus-cosine of the angle.
fn pitch(rules: &ExperimentRules, height: f64, frequency_hz: f64) -> Planned {
    let shape = OneMinusCosine::new(height, frequency_hz, 0.0).into();
    Planned::Motion { angle: rules.base_rad, of_surface: false, shape, after_s: rules.after_s }
}

/// A surface swings with a rising frequency.
fn chirp(rules: &ExperimentRules, height: f64, to_hz: f64) -> Planned {
    let shape = Chirp { height, from_hz: 0.0, to_hz, duration_s: 15.0, start_s: 0.0 }.into();
    Planned::Motion { angle: rules.base_rad, of_surface: true, shape, after_s: rules.after_s }
}

/// The angle, or a surface to both sides, up and down so slowly that nothing rings on.
fn triangle(angle: f64, height: f64, of_surface: bool) -> Planned {
    let shape = Triangle { height, duration_s: 12.0, both_sides: of_surface, start_s: 0.0 }.into();
    Planned::Motion { angle, of_surface, shape, after_s: 0.0 }
}

/// All entries.
pub fn menu(rules: &ExperimentRules) -> Vec<Experiment> {
    let pitch = |height: f64, hz: f64| pitch(rules, height, hz);
    let chirp = |height: f64, to_hz: f64| chirp(rules, height, to_hz);
    let wind_off = 0.0;
    vec![
        Experiment {
            name: "wind-off pitch at 2, 4 and 6 Hz",
            cost: 1.5,
            runs: [2.0, 4.0, 6.0].map(|hz| (wind_off, pitch(0.09, hz))).to_vec(),
        },
        Experiment {
            name: "a wind-off tilt from -6 to 12 degrees",
            cost: 0.5,
            runs: vec![(0.0, Planned::Points(-0.1, 0.21))],
        },
        Experiment { name: "pitch at 8 Hz", cost: 1.0, runs: vec![(0.75, pitch(0.07, 8.0))] },
        Experiment {
            name: "a slow triangle of pitch, up and down",
            cost: 1.0,
            runs: vec![(0.75, triangle(-0.07, 0.14 - -0.07, false))],
        },
        Experiment {
            name: "a slow triangle of a control surface",
            cost: 1.0,
            runs: vec![(0.75, triangle(rules.base_rad, 0.44, true))],
        },
        Experiment {
            name: "a chirp of a control surface to 12 Hz at small amplitude",
            cost: 1.5,
            runs: vec![(1.0, chirp(0.035, 12.0))],
        },
        Experiment {
            name: "a wide sweep of angles, -8 to 14 degrees",
            cost: 2.0,
            runs: vec![(0.6, Planned::Points(-0.14, 0.24)), (1.0, Planned::Points(-0.14, 0.24))],
        },
        Experiment {
            name: "another airspeed, a fifth faster: a sweep, pitch at 2 Hz and a chirp",
            cost: 3.0,
            runs: vec![
                (1.2, Planned::Points(-0.07, 0.14)),
                (1.2, pitch(0.09, 2.0)),
                (1.2, chirp(0.07, 10.0)),
            ],
        },
    ]
}

impl Planned {
    /// Whether its samples are static points.
    pub(crate) fn is_static(&self) -> bool {
        matches!(self, Self::Points(..))
    }

    /// As something that drives a wing; surfaces move where there are any.
    pub(crate) fn stimulus(&self, controls: usize, rules: &Rules) -> Stimulus {
        let (alpha, surface) = self.signals(rules);
        let samples = alpha.value.len();
        let still = vec![0.0; samples];
        let moved = |k: usize| if k + 1 == controls { surface.clone() } else { still.clone() };
        Stimulus {
            inputs: Inputs {
                incidence_rad: still.clone(),
                controls_rad: (0..controls).map(moved).collect(),
                alpha,
            },
            time_step_s: 1.0 / rules.data.rate_hz,
            steady: self.is_static(),
            clock_h: 0.0,
        }
    }

    fn signals(&self, rules: &Rules) -> (Smooth, Vec<f64>) {
        let (rate_hz, ExperimentRules { rest_s, points, .. }) = (rules.data.rate_hz, &rules.experiments);
        let (angle, of_surface, shape, after_s) = match self {
            Self::Motion { angle, of_surface, shape, after_s } => {
                (*angle, *of_surface, shape.kind(), *after_s)
            }
            Self::Points(from, to) => {
                let share = |i: u32| f64::from(i) / f64::from(points - 1);
                let value: Vec<f64> = (0..*points).map(|i| from + (to - from) * share(i)).collect();
                let still = vec![0.0; value.len()];
                return (Smooth { value, rate: still.clone(), second: still.clone() }, still);
            }
        };
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "some seconds of samples"
        )]
        let samples = ((rest_s + shape.length_s() + after_s) * rate_hz) as usize;
        let of = |moves: bool, value: &dyn Fn(f64) -> f64| -> Vec<f64> {
            let at = |i: usize| value(i as f64 / rate_hz - rest_s);
            (0..samples).map(|i| if moves { at(i) } else { 0.0 }).collect()
        };
        let alpha = Smooth {
            value: of(!of_surface, &|t| shape.at(t)).into_iter().map(|change| angle + change).collect(),
            rate: of(!of_surface, &|t| shape.rate(t)),
            second: of(!of_surface, &|t| shape.second(t)),
        };
        (alpha, of(of_surface, &|t| shape.at(t)))
    }
}
