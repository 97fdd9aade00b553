//! Linear chirp: a sine whose frequency runs linearly (S45: 0 to 10 Hz in 30 s is f = t/3 Hz).

use super::kind::{Kind, Recognised, Record, named};
use super::read::degrees;
use super::signal::Signal;
use schemars::JsonSchema;
use serde::Deserialize;
use std::f64::consts::{PI, TAU};

/// `height sin(2 pi (f0 t + (f1 - f0) t²/(2 T)))` for T, zero elsewhere.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Chirp {
    /// Amplitude, rad.
    #[schemars(description = "Amplitude, deg.")]
    #[serde(rename = "height_deg", deserialize_with = "degrees")]
    pub height: f64,
    /// Frequency at the beginning, Hz.
    pub from_hz: f64,
    /// Frequency at the end, Hz.
    pub to_hz: f64,
    /// Length T, s.
    pub duration_s: f64,
    /// Beginning, s.
    #[serde(default)]
    pub start_s: f64,
}

impl Chirp {
    /// Frequency at a time inside the chirp, Hz.
    pub fn frequency_hz(&self, t_s: f64) -> f64 {
        self.from_hz + (self.to_hz - self.from_hz) * (t_s - self.start_s) / self.duration_s
    }

    /// Phase and its rate inside, none outside.
    fn phase(&self, t_s: f64) -> Option<(f64, f64)> {
        let t = t_s - self.start_s;
        let sweep = (self.to_hz - self.from_hz) / self.duration_s;
        (0.0..=self.duration_s)
            .contains(&t)
            .then_some((TAU * (self.from_hz * t + 0.5 * sweep * t * t), TAU * (self.from_hz + sweep * t)))
    }
}

impl Signal for Chirp {
    fn at(&self, t_s: f64) -> f64 {
        self.phase(t_s).map_or(0.0, |(phase, _)| self.height * phase.sin())
    }

    fn rate(&self, t_s: f64) -> f64 {
        self.phase(t_s).map_or(0.0, |(phase, omega)| self.height * omega * phase.cos())
    }

    fn second(&self, t_s: f64) -> f64 {
        let sweep = 2.0 * PI * (self.to_hz - self.from_hz) / self.duration_s;
        self.phase(t_s)
            .map_or(0.0, |(phase, omega)| self.height * (sweep * phase.cos() - omega * omega * phase.sin()))
    }
}

impl Kind for Chirp {
    named!(WORDS);

    fn length_s(&self) -> f64 {
        self.duration_s
    }

    fn has_derivatives(&self) -> bool {
        true
    }

    fn above_zero(&self) -> Option<(&'static str, f64)> {
        Some(("duration_s", self.duration_s))
    }

    fn frequencies(&self) -> Vec<(&'static str, f64)> {
        vec![("from_hz", self.from_hz), ("to_hz", self.to_hz)]
    }

    fn recognised(record: &Record<'_>) -> Option<Recognised> {
        (!record.is_angle && record.oscillates()).then(|| Recognised {
            words: WORDS,
            frequency_hz: None,
            height_deg: Some(record.height().to_degrees().round()),
            sweeps: true,
        })
    }
}

const WORDS: &str = "chirp";
