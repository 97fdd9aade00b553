//! Divergence: the stiffness that the steady air takes away, `det(K - q Re Q(0)) = 0`.

use super::{Aeroelastic, FlutterError};
use coupling::divergence::lowest_pressure;
use faer::Mat;
use faer::linalg::solvers::Solve;
use structure::unsymmetric::eigenvalues;

impl Aeroelastic<'_> {
    /// Lowest divergence pressure, Pa, with the forces of an airspeed (which matters where corrections depend on it);
    /// `None` if no positive pressure diverges.
    ///
    /// # Errors
    /// If the forces are not given at rest, or eigenvalues do not converge.
    pub fn divergence_pressure(&self, v_m_s: f64) -> Result<Option<f64>, FlutterError> {
        let n = self.size();
        let q = self.forces().at(0.0, v_m_s)?;
        let real = Mat::from_fn(n, n, |i, j| q[(i, j)].re);
        let gain = self.stiffness().to_owned().partial_piv_lu().solve(&real);
        let values = eigenvalues(gain.as_ref()).ok_or(FlutterError::Eigenvalues("the steady air forces"))?;
        Ok(lowest_pressure(&values))
    }

    /// Lowest divergence airspeed at a density, m/s, up to the last of rising airspeeds (see [`first_divergence`]).
    ///
    /// # Errors
    /// As [`Aeroelastic::divergence_pressure`].
    pub fn divergence_speed(&self, rho_kg_m3: f64, speeds_m_s: &[f64]) -> Result<Option<f64>, FlutterError> {
        first_divergence(speeds_m_s, |v_m_s| {
            Ok(self.divergence_pressure(v_m_s)?.map(|q_pa| (2.0 * q_pa / rho_kg_m3).sqrt()))
        })
    }
}

/// The lowest airspeed that is its own divergence speed, m/s, where `divergence_at` gives the divergence speed of the forces at
/// an airspeed (they may depend on it by their corrections). Rising airspeeds bracket it; `None` if it is above the last.
/// If the first diverges already, it is returned.
///
/// # Errors
/// What `divergence_at` reports.
pub fn first_divergence<E>(
    speeds_m_s: &[f64],
    mut divergence_at: impl FnMut(f64) -> Result<Option<f64>, E>,
) -> Result<Option<f64>, E> {
    let mut reached =
        |v_m_s: f64| -> Result<bool, E> { Ok(divergence_at(v_m_s)?.is_some_and(|limit| v_m_s >= limit)) };
    let mut low = None;
    for &speed in speeds_m_s {
        if !reached(speed)? {
            low = Some(speed);
            continue;
        }
        let Some(mut low) = low else { return Ok(Some(speed)) };
        let mut high = speed;
        while high - low > 1e-10 * high {
            let middle = f64::midpoint(low, high);
            if reached(middle)? { high = middle } else { low = middle }
        }
        return Ok(Some(high));
    }
    Ok(None)
}
