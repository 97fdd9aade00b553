//! Divergence: the dynamic pressure at which the steady elastic problem has a solution without a cause.

use crate::error::CouplingError;
use crate::wing::ElasticWing;
use aero::Corrections;
use faer::c64;
use structure::unsymmetric::eigenvalues;

impl ElasticWing {
    /// Lowest divergence pressure of the wing with corrections of the whole lattice, Pa; `None` if no positive
    /// pressure diverges (a rigid wing, most wings swept back).
    ///
    /// `det(I - q F H) = 0` where q is one over a real positive eigenvalue of F H.
    ///
    /// # Errors
    /// If the eigenvalues do not converge (reported as a wing that diverges at any pressure).
    pub fn divergence_pressure(&self, corrections: &Corrections) -> Result<Option<f64>, CouplingError> {
        let Some(structure) = &self.supported else { return Ok(None) };
        let loop_gain = &structure.flexibility * &self.aerodynamic_stiffness(structure, corrections);
        let values = eigenvalues(loop_gain.as_ref())
            .ok_or(CouplingError::Diverged { q_pa: 0.0, divergence_pa: None })?;
        Ok(lowest_pressure(&values))
    }

    /// Lowest divergence airspeed at an air density, m/s, with corrections (one entry for each correctable box);
    /// `None` if there is none.
    ///
    /// # Errors
    /// If the corrections have the wrong length.
    pub fn divergence_speed(
        &self,
        rho_kg_m3: f64,
        corrections: &Corrections,
    ) -> Result<Option<f64>, CouplingError> {
        let padded = self.padded(corrections)?;
        Ok(self.divergence_pressure(&padded)?.map(|q_pa| (2.0 * q_pa / rho_kg_m3).sqrt()))
    }
}

/// One over the largest positive real eigenvalue of a loop's gain per unit pressure: the lowest pressure at which the loop
/// closes on itself; `None` if there is none.
pub fn lowest_pressure(gains: &[c64]) -> Option<f64> {
    let scale = gains.iter().map(|value| value.norm()).fold(0.0, f64::max);
    let largest = gains
        .iter()
        .filter(|value| value.im.abs() <= 1e-9 * value.re.abs() && value.re > 1e-9 * scale)
        .map(|value| value.re)
        .fold(0.0, f64::max);
    (largest > 0.0).then(|| 1.0 / largest)
}
