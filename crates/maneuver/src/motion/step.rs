//! A step that stays.

use super::kind::{Kind, named};
use super::read::degrees;
use super::signal::{EDGE, Signal};
use schemars::JsonSchema;
use serde::Deserialize;

/// Zero before, `height` from `start_s` on.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Step {
    /// Height, rad.
    #[schemars(description = "Height, deg.")]
    #[serde(rename = "height_deg", deserialize_with = "degrees")]
    pub height: f64,
    /// Beginning, s.
    #[serde(default)]
    pub start_s: f64,
}

impl Signal for Step {
    fn at(&self, t_s: f64) -> f64 {
        if t_s + EDGE >= self.start_s { self.height } else { 0.0 }
    }
}

impl Kind for Step {
    named!("step");

    fn length_s(&self) -> f64 {
        0.0
    }

    fn jumps(&self) -> bool {
        true
    }
}
