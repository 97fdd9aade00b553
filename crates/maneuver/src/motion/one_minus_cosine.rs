//! One-minus-cosine: up and back once, without a jump of value or rate (S35).

use super::kind::{Kind, Mover, Recognised, Record, named};
use super::read::{degrees, some_degrees};
use super::signal::Signal;
use schemars::JsonSchema;
use serde::Deserialize;
use std::f64::consts::TAU;

/// An angle that changes by less than this is still, rad.
const STILL_RAD: f64 = 2e-3;

/// `height/2 (1 - cos(2 pi f (t - start)))` for one period, zero elsewhere.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct OneMinusCosine {
    /// Largest departure, rad.
    #[schemars(description = "Largest departure, deg.")]
    #[serde(rename = "height_deg", deserialize_with = "degrees", default = "not_given")]
    pub height: f64,
    /// In place of the height, the angle of attack it goes to, rad.
    #[schemars(description = "In place of the height, the angle of attack it goes to, deg.")]
    #[serde(rename = "to_deg", deserialize_with = "some_degrees", default)]
    pub to: Option<f64>,
    /// One over the duration, Hz.
    pub frequency_hz: f64,
    /// Beginning, s.
    #[serde(default)]
    pub start_s: f64,
}

impl OneMinusCosine {
    /// With a height in rad.
    pub fn new(height: f64, frequency_hz: f64, start_s: f64) -> Self {
        Self { height, to: None, frequency_hz, start_s }
    }

    /// Phase in rad inside the period, none outside.
    fn phase(&self, t_s: f64) -> Option<f64> {
        let phase = TAU * self.frequency_hz * (t_s - self.start_s);
        (0.0..TAU).contains(&phase).then_some(phase)
    }
}

impl Signal for OneMinusCosine {
    fn at(&self, t_s: f64) -> f64 {
        self.phase(t_s).map_or(0.0, |phase| 0.5 * self.height * (1.0 - phase.cos()))
    }

    fn rate(&self, t_s: f64) -> f64 {
        let omega = TAU * self.frequency_hz;
        self.phase(t_s).map_or(0.0, |phase| 0.5 * self.height * omega * phase.sin())
    }

    fn second(&self, t_s: f64) -> f64 {
        let omega = TAU * self.frequency_hz;
        self.phase(t_s).map_or(0.0, |phase| 0.5 * self.height * omega * omega * phase.cos())
    }
}

impl Kind for OneMinusCosine {
    named!(WORDS);

    fn length_s(&self) -> f64 {
        1.0 / self.frequency_hz
    }

    fn has_derivatives(&self) -> bool {
        true
    }

    fn above_zero(&self) -> Option<(&'static str, f64)> {
        Some(("frequency_hz", self.frequency_hz))
    }

    fn mover(&self) -> Mover {
        if self.to.is_some() { Mover::Angle } else { Mover::Named }
    }

    fn count_from(&mut self, base: f64) {
        if let Some(to) = self.to {
            self.height = to - base;
        }
    }

    /// One or several full waves between two angles: above the middle for half the time.
    fn recognised(record: &Record<'_>) -> Option<Recognised> {
        let frequency_hz = frequency_hz(record.values, record.time_step_s).filter(|_| record.is_angle);
        frequency_hz.map(|hz| Recognised {
            words: WORDS,
            frequency_hz: Some(hz),
            height_deg: None,
            sweeps: false,
        })
    }
}

const WORDS: &str = "pitch";

/// A height that reading refuses unless there is `to_deg`.
fn not_given() -> f64 {
    f64::NAN
}

fn frequency_hz(alpha_rad: &[f64], time_step_s: f64) -> Option<f64> {
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
