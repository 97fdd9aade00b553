//! Power spectral densities of turbulence over the wave number Omega = omega/V, normalised to a variance of one.

use crate::design::Spectrum;
use std::f64::consts::PI;

impl Spectrum {
    /// Phi at a wave number, rad/m, for a scale, m: m/rad. One-sided: its integral from zero on is one (von Karman's 0.999988, as 1.339
    /// is rounded and the rule does not normalise).
    ///
    /// Von Karman: 14 CFR 25.341(b)(2) and appendix G. Dryden: MIL-F-8785C, the same normalisation.
    pub fn density(self, wave_number_rad_m: f64, scale_m: f64) -> f64 {
        let x = scale_m * wave_number_rad_m;
        match self {
            Self::Karman => {
                let square = (1.339 * x).powi(2);
                scale_m / PI * (1.0 + 8.0 / 3.0 * square) / (1.0 + square).powf(11.0 / 6.0)
            }
            Self::Dryden => scale_m / PI * (1.0 + 3.0 * x * x) / (1.0 + x * x).powi(2),
        }
    }

    /// Variance beyond a wave number far above 1/scale, by the power that Phi falls with there.
    pub(super) fn beyond(self, wave_number_rad_m: f64, scale_m: f64) -> f64 {
        let factor = match self {
            // Omega^(-5/3) and Omega^(-2).
            Self::Karman => 1.5,
            Self::Dryden => 1.0,
        };
        factor * wave_number_rad_m * self.density(wave_number_rad_m, scale_m)
    }
}
