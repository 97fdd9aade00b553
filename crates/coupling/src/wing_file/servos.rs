//! The servos between commanded deflections and control surfaces, and how well they are known.

use crate::planform::Fault;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// What stands between a commanded deflection and every control surface.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub enum Servos {
    /// Nothing: deflections are those of the surfaces, measured at the hinge.
    None,
    /// Servos of second order, `d'' = w² (command - d) - 2 zeta w d'`.
    SecondOrder {
        /// Natural frequency w.
        frequency_hz: f64,
        /// Damping ratio zeta.
        damping_ratio: f64,
        /// One standard deviation of the frequency.
        frequency_sd_hz: f64,
        /// One standard deviation of the damping ratio.
        damping_ratio_sd: f64,
    },
}

impl Default for Servos {
    /// Assumed, as hobby servos under load are: a tenth either way.
    fn default() -> Self {
        Self::SecondOrder {
            frequency_hz: 15.0,
            damping_ratio: 0.8,
            frequency_sd_hz: 1.0,
            damping_ratio_sd: 0.05,
        }
    }
}

impl Servos {
    /// Whether a file need not say it.
    pub(super) fn is_default(&self) -> bool {
        *self == Self::default()
    }

    /// One standard deviation of the period and of the damping ratio, as shares of them; zero without servos.
    pub fn relative_sd(&self) -> [f64; 2] {
        match *self {
            Self::None => [0.0; 2],
            Self::SecondOrder { frequency_hz, damping_ratio, frequency_sd_hz, damping_ratio_sd } => {
                [frequency_sd_hz / frequency_hz, damping_ratio_sd / damping_ratio]
            }
        }
    }

    pub(super) fn check(&self) -> Result<(), Fault> {
        let Self::SecondOrder { frequency_hz, damping_ratio, frequency_sd_hz, damping_ratio_sd } = *self
        else {
            return Ok(());
        };
        let possible = (0.1..=1e4).contains(&frequency_hz) && (0.05..=10.0).contains(&damping_ratio);
        // a linear share of the period is what a deviation stands for
        let known = |sd: f64, of: f64| (0.0..=0.5 * of).contains(&sd);
        if possible && known(frequency_sd_hz, frequency_hz) && known(damping_ratio_sd, damping_ratio) {
            return Ok(());
        }
        let message = format!(
            "servos of {frequency_hz:?} +- {frequency_sd_hz:?} Hz and a damping ratio of {damping_ratio:?} +- \
             {damping_ratio_sd:?}"
        );
        let help = "0.1 to 10000 Hz and 0.05 to 10, each with a standard deviation up to half of it; `servos: None` if \
                    deflections are those of the surfaces";
        Err(Fault::field("servos", message, help))
    }
}
