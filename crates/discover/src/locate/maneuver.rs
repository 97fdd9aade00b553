//! What kind of maneuver a stimulus is, read from the motion itself: names of files say nothing for certain.

use crate::rules::LocateRules;
use maneuver::effects::Stimulus;
use maneuver::motion::{Recognised, Record, recognised};
use std::fmt;

/// See the module.
#[derive(Debug, Clone, PartialEq)]
pub enum Maneuver {
    /// Static points.
    Static {
        /// Whether there is wind.
        wind: bool,
    },
    /// The balance pitches.
    Angle {
        /// Whether there is wind.
        wind: bool,
        /// The kind of motion.
        kind: Recognised,
    },
    /// One control moves.
    Control {
        /// Place of the control.
        control: usize,
        /// The kind of motion.
        kind: Recognised,
    },
    /// Anything else.
    Other,
}

impl Maneuver {
    /// Of a stimulus at an airspeed (zero: still air).
    pub fn of(rules: &LocateRules, stimulus: &Stimulus, v_m_s: f64) -> Self {
        let wind = v_m_s > 0.0;
        if stimulus.steady {
            return Self::Static { wind };
        }
        let record = |values, is_angle| Record { values, time_step_s: stimulus.time_step_s, is_angle };
        let controls = &stimulus.inputs.controls_rad;
        let moving: Vec<usize> =
            (0..controls.len()).filter(|&c| record(&controls[c], false).height() > rules.still_rad).collect();
        let found = match moving[..] {
            [] => {
                recognised(&record(&stimulus.inputs.alpha.value, true)).map(|kind| Self::Angle { wind, kind })
            }
            [control] => {
                recognised(&record(&controls[control], false)).map(|kind| Self::Control { control, kind })
            }
            _ => None,
        };
        found.unwrap_or(Self::Other)
    }

    /// The kind of motion; none for static points and what is not recognised.
    pub fn kind(&self) -> Option<Recognised> {
        match self {
            Self::Angle { kind, .. } | Self::Control { kind, .. } => Some(*kind),
            Self::Static { .. } | Self::Other => None,
        }
    }

    /// The control that moves with a frequency that runs.
    pub fn swept_control(&self) -> Option<usize> {
        match self {
            Self::Control { control, kind } if kind.sweeps => Some(*control),
            _ => None,
        }
    }

    /// Whether two are of a kind, whatever their size and frequency.
    pub fn same_kind(&self, other: &Self) -> bool {
        let words = |maneuver: &Self| maneuver.kind().map(|kind| kind.words);
        match (self, other) {
            (Self::Static { wind: a }, Self::Static { wind: b })
            | (Self::Angle { wind: a, .. }, Self::Angle { wind: b, .. })
                if a != b =>
            {
                false
            }
            _ => std::mem::discriminant(self) == std::mem::discriminant(other) && words(self) == words(other),
        }
    }

    /// In words, with the names of the controls.
    pub fn label(&self, controls: &[String]) -> String {
        let number = |value: Option<f64>, unit: &str| value.map_or(String::new(), |v| format!(" {v} {unit}"));
        let size = |kind: &Recognised| number(kind.frequency_hz, "Hz") + &number(kind.height_deg, "deg");
        match self {
            Self::Static { wind: true } => "static points".to_owned(),
            Self::Static { wind: false } => "wind-off tilt".to_owned(),
            Self::Angle { wind, kind } => {
                format!("{}{}{}", if *wind { "" } else { "wind-off " }, kind.words, size(kind))
            }
            Self::Control { control, kind } => {
                let name = controls.get(*control).map_or("control", String::as_str);
                format!("{} {name}{}", kind.words, size(kind))
            }
            Self::Other => "other".to_owned(),
        }
    }
}

impl fmt::Display for Maneuver {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.label(&[]))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use maneuver::Smooth;
    use maneuver::effects::Inputs;

    fn moved(alpha: impl Fn(f64) -> f64, delta: impl Fn(f64) -> f64) -> Maneuver {
        let t: Vec<f64> = (0..1000).map(|i| f64::from(i) * 0.01).collect();
        let zero = vec![0.0; t.len()];
        let value: Vec<f64> = t.iter().map(|t| alpha(*t).to_radians()).collect();
        let alpha = Smooth { value, rate: zero.clone(), second: zero.clone() };
        let controls_rad = vec![zero.clone(), t.iter().map(|t| delta(*t).to_radians()).collect()];
        let inputs = Inputs { alpha, incidence_rad: zero, controls_rad };
        let stimulus = Stimulus { inputs, time_step_s: 0.01, steady: false, clock_h: 0.0 };
        Maneuver::of(&LocateRules::default(), &stimulus, 30.0)
    }

    #[test]
    fn a_maneuver_is_known_by_its_motion() {
        let bump = |hz: f64| {
            move |t: f64| if t < 1.0 / hz { 2.0 - 2.0 * (std::f64::consts::TAU * hz * t).cos() } else { 0.0 }
        };
        assert_eq!(moved(bump(0.5), |_| 0.0).to_string(), "pitch 0.5 Hz");
        assert_eq!(moved(bump(4.0), |_| 0.0).to_string(), "pitch 4 Hz");
        let step = |t: f64| {
            if !(1.0..3.0).contains(&t) {
                0.0
            } else if t < 2.0 {
                15.0
            } else {
                -15.0
            }
        };
        let names = ["inner", "outer"].map(str::to_owned);
        assert_eq!(moved(|_| 1.0, step).label(&names), "doublet outer 15 deg");
        let chirp = moved(|_| 1.0, |t| 5.0 * (0.5 * t * t).sin());
        assert_eq!((chirp.label(&names).as_str(), chirp.swept_control()), ("chirp outer 5 deg", Some(1)));
        assert_eq!(moved(|_| 1.0, |_| 0.0), Maneuver::Other);
    }
}
