//! Triangle: straight up and straight down once, to one side or to both: slow enough, it shows hysteresis.

use super::kind::{Kind, named};
use super::read::degrees;
use super::signal::Signal;
use schemars::JsonSchema;
use serde::Deserialize;

/// Straight lines through 0, `height`, 0, and, to both sides, `-height`, 0.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Triangle {
    /// Height, rad.
    #[schemars(description = "Height, deg.")]
    #[serde(rename = "height_deg", deserialize_with = "degrees")]
    pub height: f64,
    /// From beginning to end.
    pub duration_s: f64,
    /// Whether it goes to the other side, too.
    #[serde(default)]
    pub both_sides: bool,
    /// Beginning, s.
    #[serde(default)]
    pub start_s: f64,
}

impl Triangle {
    /// From zero to one and back over one unit, zero outside.
    fn unit(share: f64) -> f64 {
        if (0.0..1.0).contains(&share) { 1.0 - (2.0 * share - 1.0).abs() } else { 0.0 }
    }

    /// Share of the duration that has gone by, and the length of one triangle, s.
    fn one_s(&self) -> f64 {
        if self.both_sides { 0.5 * self.duration_s } else { self.duration_s }
    }
}

impl Signal for Triangle {
    fn at(&self, t_s: f64) -> f64 {
        let share = (t_s - self.start_s) / self.one_s();
        let other = if self.both_sides { Self::unit(share - 1.0) } else { 0.0 };
        self.height * (Self::unit(share) - other)
    }

    fn rate(&self, t_s: f64) -> f64 {
        let share = (t_s - self.start_s) / self.one_s();
        let slope = 2.0 * self.height / self.one_s();
        match share {
            share if (0.0..0.5).contains(&share) => slope,
            share if (0.5..1.0).contains(&share) => -slope,
            share if self.both_sides && (1.0..1.5).contains(&share) => -slope,
            share if self.both_sides && (1.5..2.0).contains(&share) => slope,
            _ => 0.0,
        }
    }
}

impl Kind for Triangle {
    named!("triangle");

    fn length_s(&self) -> f64 {
        self.duration_s
    }

    fn above_zero(&self) -> Option<(&'static str, f64)> {
        Some(("duration_s", self.duration_s))
    }
}
