//! What kind of maneuver a stimulus is, read from the motion itself: names of files say nothing for certain.

use maneuver::effects::Stimulus;
use std::fmt;

/// A motion smaller than this is none, rad.
const STILL_RAD: f64 = 2e-3;
/// Deflections count as those of a doublet if they are within this share of its height.
const FLAT: f64 = 0.05;
/// Share of the moved samples that must be flat in a doublet: the rest is the way between.
const MOSTLY: f64 = 0.8;
/// So many crossings of zero make a chirp.
const CHIRP_CROSSINGS: usize = 8;

/// See the module.
#[derive(Debug, Clone, PartialEq)]
pub enum Maneuver {
    /// Static points.
    Static {
        /// Whether there is wind.
        wind: bool,
    },
    /// The balance pitches.
    Pitch {
        /// Whether there is wind.
        wind: bool,
        /// Frequency of the motion, Hz, two digits.
        frequency_hz: f64,
    },
    /// A control goes up and down once.
    Doublet {
        /// Place of the control.
        control: usize,
        /// Its height, whole degrees.
        height_deg: f64,
    },
    /// A control sweeps through frequencies.
    Chirp {
        /// Place of the control.
        control: usize,
        /// Its height, whole degrees.
        height_deg: f64,
    },
    /// Anything else.
    Other,
}

impl Maneuver {
    /// Of a stimulus at an airspeed (zero: still air).
    pub fn of(stimulus: &Stimulus, v_m_s: f64) -> Self {
        let wind = v_m_s > 0.0;
        if stimulus.steady {
            return Self::Static { wind };
        }
        let moving: Vec<usize> = (0..stimulus.inputs.controls_rad.len())
            .filter(|&c| largest(&stimulus.inputs.controls_rad[c]) > STILL_RAD)
            .collect();
        match moving[..] {
            [] => pitch_hz(&stimulus.inputs.alpha.value, stimulus.time_step_s)
                .map_or(Self::Other, |frequency_hz| Self::Pitch { wind, frequency_hz }),
            [control] => of_control(control, &stimulus.inputs.controls_rad[control]),
            _ => Self::Other,
        }
    }

    /// Whether two are of a kind, whatever their size and frequency.
    pub fn same_kind(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Static { wind: a }, Self::Static { wind: b })
            | (Self::Pitch { wind: a, .. }, Self::Pitch { wind: b, .. }) => a == b,
            _ => std::mem::discriminant(self) == std::mem::discriminant(other),
        }
    }

    /// In words, with the names of the controls.
    pub fn label(&self, controls: &[String]) -> String {
        let name = |c: &usize| controls.get(*c).map_or("control", String::as_str);
        match self {
            Self::Static { wind: true } => "static points".to_owned(),
            Self::Static { wind: false } => "wind-off tilt".to_owned(),
            Self::Pitch { wind, frequency_hz } => {
                format!("{}pitch {frequency_hz} Hz", if *wind { "" } else { "wind-off " })
            }
            Self::Doublet { control, height_deg } => format!("doublet {} {height_deg} deg", name(control)),
            Self::Chirp { control, height_deg } => format!("chirp {} {height_deg} deg", name(control)),
            Self::Other => "other".to_owned(),
        }
    }
}

impl fmt::Display for Maneuver {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.label(&[]))
    }
}

fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |most: f64, value| most.max(value.abs()))
}

fn of_control(control: usize, values: &[f64]) -> Maneuver {
    let height = largest(values);
    let height_deg = height.to_degrees().round();
    let near =
        |sign: f64| values.iter().filter(|delta| (**delta - sign * height).abs() <= FLAT * height).count();
    let away = values.iter().filter(|delta| delta.abs() > FLAT * height).count();
    let (up, down) = (near(1.0), near(-1.0));
    let signs: Vec<bool> =
        values.iter().filter(|delta| delta.abs() > FLAT * height).map(|delta| *delta > 0.0).collect();
    let crossings = signs.windows(2).filter(|pair| pair[0] != pair[1]).count();
    if crossings >= CHIRP_CROSSINGS {
        Maneuver::Chirp { control, height_deg }
    } else if up > 0 && down > 0 && (up + down) as f64 >= MOSTLY * away as f64 {
        Maneuver::Doublet { control, height_deg }
    } else {
        Maneuver::Other
    }
}

/// Frequency of one or several full waves between two angles: above the middle for half the time.
fn pitch_hz(alpha_rad: &[f64], time_step_s: f64) -> Option<f64> {
    let low = alpha_rad.iter().copied().fold(f64::INFINITY, f64::min);
    let high = alpha_rad.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    if high.is_nan() || high - low < STILL_RAD {
        return None;
    }
    // part of the step between two samples that is above the middle, straight lines between
    let middle = 0.5 * (low + high);
    let above = |pair: &[f64]| {
        let (least, most) = (pair[0].min(pair[1]), pair[0].max(pair[1]));
        if most > least {
            ((most - middle) / (most - least)).clamp(0.0, 1.0)
        } else {
            f64::from(least > middle)
        }
    };
    let time_s = alpha_rad.windows(2).map(above).sum::<f64>() * time_step_s;
    // noise crosses the middle to and fro: once above, the angle must come down by a quarter before it counts again
    let (mut waves, mut up) = (0.0, false);
    for value in alpha_rad {
        let share = (value - low) / (high - low);
        if !up && share > 0.5 {
            up = true;
            waves += 1.0;
        } else if share < 0.25 {
            up = false;
        }
    }
    let raw: f64 = 0.5 * waves / time_s;
    let digit = 10_f64.powf(raw.log10().floor() - 1.0);
    Some((raw / digit).round() * digit).map(|hz| (hz * 1e4).round() / 1e4)
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
        Maneuver::of(&Stimulus { inputs, time_step_s: 0.01, steady: false, clock_h: 0.0 }, 30.0)
    }

    #[test]
    fn a_maneuver_is_known_by_its_motion() {
        let bump = |hz: f64| {
            move |t: f64| if t < 1.0 / hz { 2.0 - 2.0 * (std::f64::consts::TAU * hz * t).cos() } else { 0.0 }
        };
        assert_eq!(moved(bump(0.5), |_| 0.0), Maneuver::Pitch { wind: true, frequency_hz: 0.5 });
        assert_eq!(moved(bump(4.0), |_| 0.0), Maneuver::Pitch { wind: true, frequency_hz: 4.0 });
        let step = |t: f64| {
            if !(1.0..3.0).contains(&t) {
                0.0
            } else if t < 2.0 {
                15.0
            } else {
                -15.0
            }
        };
        assert_eq!(moved(|_| 1.0, step), Maneuver::Doublet { control: 1, height_deg: 15.0 });
        let chirp = moved(|_| 1.0, |t| 5.0 * (0.5 * t * t).sin());
        assert_eq!(chirp, Maneuver::Chirp { control: 1, height_deg: 5.0 });
        assert_eq!(moved(|_| 1.0, |_| 0.0), Maneuver::Other);
    }
}
