//! The standard atmosphere (U.S. Standard Atmosphere 1976, the same as ISO 2533) from the ground to 20 km of geopotential altitude.

/// Density at sea level that equivalent airspeeds refer to, kg/m^3.
pub const RHO0_KG_M3: f64 = 1.225;
/// Standard acceleration of gravity, m/s^2.
pub const G_M_S2: f64 = 9.80665;
/// Lowest and highest altitude, m.
pub const ALTITUDES_M: std::ops::RangeInclusive<f64> = -2000.0..=20_000.0;

/// Gas constant of air, J/(kg K): 8314.32 over 28.9644.
const R_AIR: f64 = 287.052_87;
/// Temperature, K, and pressure, Pa, at sea level.
const SEA_LEVEL: (f64, f64) = (288.15, 101_325.0);
/// Lapse of the temperature below the tropopause, K/m.
const LAPSE_K_M: f64 = 0.0065;
/// Altitude of the tropopause, m.
const TROPOPAUSE_M: f64 = 11_000.0;

/// Air at an altitude.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Air {
    /// Temperature, K.
    pub temperature_k: f64,
    /// Pressure, Pa.
    pub pressure_pa: f64,
    /// Density, kg/m^3.
    pub rho_kg_m3: f64,
    /// Speed of sound, m/s.
    pub sound_m_s: f64,
}

impl Air {
    /// The standard atmosphere at a geopotential altitude, m, within [`ALTITUDES_M`].
    pub fn at(h_m: f64) -> Self {
        let (t0, p0) = SEA_LEVEL;
        let exponent = G_M_S2 / (R_AIR * LAPSE_K_M);
        let below = |h: f64| {
            let temperature = t0 - LAPSE_K_M * h;
            (temperature, p0 * (temperature / t0).powf(exponent))
        };
        let (temperature_k, pressure_pa) = if h_m <= TROPOPAUSE_M {
            below(h_m)
        } else {
            let (temperature, pressure) = below(TROPOPAUSE_M);
            (temperature, pressure * (-G_M_S2 * (h_m - TROPOPAUSE_M) / (R_AIR * temperature)).exp())
        };
        Self {
            temperature_k,
            pressure_pa,
            rho_kg_m3: pressure_pa / (R_AIR * temperature_k),
            sound_m_s: (1.4 * R_AIR * temperature_k).sqrt(),
        }
    }

    /// True airspeed over equivalent airspeed: the root of the density at sea level over the density here.
    pub fn true_over_equivalent(&self) -> f64 {
        (RHO0_KG_M3 / self.rho_kg_m3).sqrt()
    }
}
