//! Divergence: the stiffness that the steady air takes away, `det(K - q Re Q(0)) = 0`.

use super::{Aeroelastic, FlutterError};
use faer::Mat;
use faer::linalg::solvers::Solve;

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
        let values = gain.eigenvalues().map_err(|_| FlutterError::Eigenvalues("the steady air forces"))?;
        let scale = values.iter().map(|value| value.norm()).fold(0.0, f64::max);
        let largest = values
            .iter()
            .filter(|value| value.im.abs() <= 1e-9 * value.re.abs() && value.re > 1e-9 * scale)
            .map(|value| value.re)
            .fold(0.0, f64::max);
        Ok((largest > 0.0).then(|| 1.0 / largest))
    }

    /// Lowest divergence airspeed at a density, m/s, looked for between two airspeeds in steps: exact where the forces do not
    /// depend on the airspeed; where they do, the first airspeed at which the pressure of divergence is reached.
    ///
    /// # Errors
    /// As [`Aeroelastic::divergence_pressure`].
    pub fn divergence_speed(&self, rho_kg_m3: f64, speeds_m_s: &[f64]) -> Result<Option<f64>, FlutterError> {
        let over = |v: f64| -> Result<f64, FlutterError> {
            let pressure = self.divergence_pressure(v)?;
            Ok(pressure.map_or(f64::NEG_INFINITY, |q_d| v - (2.0 * q_d / rho_kg_m3).sqrt()))
        };
        let Some(&first) = speeds_m_s.first() else {
            return Err(FlutterError::Empty("the list of airspeeds"));
        };
        let mut low = first;
        if over(first)? >= 0.0 {
            return Ok(Some(first));
        }
        for &speed in &speeds_m_s[1..] {
            if over(speed)? >= 0.0 {
                let mut high = speed;
                while high - low > 1e-10 * high {
                    let middle = f64::midpoint(low, high);
                    if over(middle)? >= 0.0 { high = middle } else { low = middle }
                }
                return Ok(Some(high));
            }
            low = speed;
        }
        Ok(None)
    }
}
