//! What is kept from a fit: every second airspeed and whole days.

use crate::campaign::Run;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Airspeeds nearer than this are one, m/s: a stream is set by hand.
const ONE_AIRSPEED_M_S: f64 = 0.3;

/// What is kept from a fit.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct HeldOut {
    /// Every second airspeed, from the second lowest on.
    #[serde(default)]
    pub every_second_airspeed: bool,
    /// Whole days.
    #[serde(default)]
    pub days: Vec<u32>,
}

impl HeldOut {
    /// Of each run whether it is kept from a fit.
    pub fn of(&self, runs: &[Run]) -> Vec<bool> {
        let mut airspeeds: Vec<f64> = runs.iter().map(|run| run.airspeed_m_s).collect();
        airspeeds.sort_by(f64::total_cmp);
        let held = |run: &Run| {
            let below = airspeeds.windows(2).filter(|pair| pair[1] <= run.airspeed_m_s);
            let place = below.filter(|pair| pair[1] - pair[0] > ONE_AIRSPEED_M_S).count();
            self.days.contains(&run.day) || self.every_second_airspeed && place % 2 == 1
        };
        runs.iter().map(held).collect()
    }
}
