//! Doublet: to one side for half a period, to the other for the other half.

use super::kind::{Kind, Recognised, Record, named};
use super::read::degrees;
use super::signal::{EDGE, Signal};
use schemars::JsonSchema;
use serde::Deserialize;

/// Deflections count as those of a doublet if they are within this share of its height.
const FLAT: f64 = 0.05;
/// Share of the moved samples that must be flat in a doublet: the rest is the way between.
const MOSTLY: f64 = 0.8;

/// `+height` for half a period, `-height` for the other half.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Doublet {
    /// Height of each half, rad.
    #[schemars(description = "Height of each half, deg.")]
    #[serde(rename = "height_deg", deserialize_with = "degrees")]
    pub height: f64,
    /// One over the length of both halves, Hz.
    pub frequency_hz: f64,
    /// Beginning, s.
    #[serde(default)]
    pub start_s: f64,
}

impl Doublet {
    /// Whether a record goes to plus and minus one height, and is hardly ever between.
    pub fn fits(record: &Record<'_>) -> bool {
        let height = record.height();
        let near = |sign: f64| {
            record.values.iter().filter(|delta| (**delta - sign * height).abs() <= FLAT * height).count()
        };
        let away = record.values.iter().filter(|delta| delta.abs() > FLAT * height).count();
        let (up, down) = (near(1.0), near(-1.0));
        up > 0 && down > 0 && (up + down) as f64 >= MOSTLY * away as f64
    }
}

impl Signal for Doublet {
    fn at(&self, t_s: f64) -> f64 {
        match (t_s - self.start_s) * self.frequency_hz + EDGE {
            share if (0.0..0.5).contains(&share) => self.height,
            share if (0.5..1.0).contains(&share) => -self.height,
            _ => 0.0,
        }
    }
}

impl Kind for Doublet {
    named!(WORDS);

    fn length_s(&self) -> f64 {
        1.0 / self.frequency_hz
    }

    fn jumps(&self) -> bool {
        true
    }

    fn above_zero(&self) -> Option<(&'static str, f64)> {
        Some(("frequency_hz", self.frequency_hz))
    }

    fn recognised(record: &Record<'_>) -> Option<Recognised> {
        (!record.is_angle && !record.oscillates() && Self::fits(record)).then(|| Recognised {
            words: WORDS,
            frequency_hz: None,
            height_deg: Some(record.height().to_degrees().round()),
            sweeps: false,
        })
    }
}

const WORDS: &str = "doublet";
