//! 3-2-1-1: three units up, two down, one up, one down.

use super::kind::{Kind, named};
use super::read::degrees;
use super::signal::{EDGE, Signal};
use schemars::JsonSchema;
use serde::Deserialize;

/// Four blocks of alternating sign, of three, two, one and one units.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ThreeTwoOneOne {
    /// Height, rad.
    #[schemars(description = "Height, deg.")]
    #[serde(rename = "height_deg", deserialize_with = "degrees")]
    pub height: f64,
    /// Length of one unit, s.
    pub unit_s: f64,
    /// Beginning, s.
    #[serde(default)]
    pub start_s: f64,
}

impl Signal for ThreeTwoOneOne {
    fn at(&self, t_s: f64) -> f64 {
        match (t_s - self.start_s) / self.unit_s + EDGE {
            unit if (0.0..3.0).contains(&unit) || (5.0..6.0).contains(&unit) => self.height,
            unit if (3.0..5.0).contains(&unit) || (6.0..7.0).contains(&unit) => -self.height,
            _ => 0.0,
        }
    }
}

impl Kind for ThreeTwoOneOne {
    named!("3-2-1-1");

    fn length_s(&self) -> f64 {
        7.0 * self.unit_s
    }

    fn jumps(&self) -> bool {
        true
    }

    fn above_zero(&self) -> Option<(&'static str, f64)> {
        Some(("unit_s", self.unit_s))
    }

    /// A unit is half a period of its fastest part.
    fn frequencies(&self) -> Vec<(&'static str, f64)> {
        vec![("unit_s", 0.5 / self.unit_s)]
    }
}
