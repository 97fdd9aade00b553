//! How well the tests before the tunnel leave a wing known.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// One standard deviation of what a wing's model is off by after static loads and natural modes, weighing, free decay and the
/// check of its sensors; what `discover` finds within it is no missing effect. Zero: known exactly.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct KnownTo {
    /// Of the bending stiffness, as a share.
    pub bending: f64,
    /// Of the torsional stiffness, as a share.
    pub torsion: f64,
    /// Of the mass, as a share.
    pub mass: f64,
    /// Of the structural damping, as a share of it.
    pub damping: f64,
    /// Of the apparent mass of the air, as a share.
    pub apparent_mass: f64,
    /// Of the wake's lag, and of all that is unsteady, as a share.
    pub wake_lag: f64,
    /// Of what all control surfaces do, as a share.
    pub surfaces: f64,
    /// Of what the linkage gives way at 30 m/s, as a share of a deflection.
    pub linkage: f64,
    /// Of the zero of the angle of attack, degrees.
    pub alpha_deg: f64,
    /// Of the time between the balance's clock and the others', s.
    pub clock_s: f64,
}

impl Default for KnownTo {
    fn default() -> Self {
        Self {
            bending: 0.01,
            torsion: 0.02,
            mass: 0.007,
            damping: 0.1,
            apparent_mass: 0.04,
            wake_lag: 0.07,
            surfaces: 0.01,
            linkage: 0.01,
            alpha_deg: 0.01,
            clock_s: 0.001,
        }
    }
}

impl KnownTo {
    /// Whether a file need not say it.
    pub(super) fn is_default(&self) -> bool {
        *self == Self::default()
    }

    /// Names, values, and the most they may be.
    pub(super) fn values(&self) -> [(&'static str, f64, f64); 10] {
        macro_rules! each {
            ($($field:ident: $most:literal),+) => {
                [$((stringify!($field), self.$field, $most)),+]
            };
        }
        each!(
            bending: 0.5,
            torsion: 0.5,
            mass: 0.5,
            damping: 1.0,
            apparent_mass: 0.5,
            wake_lag: 0.5,
            surfaces: 0.5,
            linkage: 0.5,
            alpha_deg: 5.0,
            clock_s: 0.05
        )
    }
}
