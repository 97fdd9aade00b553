//! The K method: at a reduced frequency the airspeed and the structural damping at which an oscillation neither grows nor
//! decays (Rodden and Johnson, *MSC/NASTRAN Aeroelastic Analysis User's Guide*, 1994, ch. 2).
//!
//! ```text
//! [(kappa² M + rho/2 Q(kappa)) p² + kappa C p + K] u = 0,   p = i V / sqrt(1 + i g),   omega = kappa V
//! ```

use super::{Aeroelastic, FlutterError};
use faer::linalg::solvers::Solve;
use faer::{Mat, c64};

/// An oscillation that stays as it is with a structural damping of `g`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct KRoot {
    /// Airspeed, m/s.
    pub v_m_s: f64,
    /// Structural damping that it needs; flutter is where it is zero, and above zero it grows without it.
    pub g: f64,
    /// Frequency, rad/s.
    pub omega_rad_s: f64,
}

impl Aeroelastic<'_> {
    /// The oscillations at omega/V = `kappa` (1/m, above zero) in air of density `rho_kg_m3`, by rising airspeed.
    ///
    /// # Errors
    /// If kappa is outside of the table of forces, or eigenvalues do not converge.
    pub fn k_roots(&self, kappa: f64, rho_kg_m3: f64) -> Result<Vec<KRoot>, FlutterError> {
        let n = self.size();
        let q = self.forces().at(kappa, 1.0)?;
        let inertia = Mat::from_fn(n, n, |i, j| {
            c64::from(kappa * kappa * self.mass()[(i, j)]) + q[(i, j)] * (0.5 * rho_kg_m3)
        });
        let right = Mat::from_fn(n, 2 * n, |i, j| {
            let value = if j < n { self.stiffness()[(i, j)] } else { kappa * self.damping()[(i, j - n)] };
            c64::from(-value)
        });
        let lower = inertia.partial_piv_lu().solve(right);
        let a = Mat::from_fn(2 * n, 2 * n, |i, j| match i.checked_sub(n) {
            None => c64::from(f64::from(u8::from(j == i + n))),
            Some(row) => lower[(row, j)],
        });
        let all = a.eigenvalues().map_err(|_| FlutterError::Eigenvalues("the K method"))?;
        let largest = all.iter().map(|p| p.norm()).fold(0.0, f64::max);
        let root = |p: &c64| {
            // 1 + i g = -V²/p²
            let inverse = -c64::from(1.0) / (*p * *p);
            let v_m_s = (1.0 / inverse.re).sqrt();
            let is_one = p.im > 0.0 && p.norm() > 1e-6 * largest && v_m_s.is_finite();
            is_one.then_some(KRoot { v_m_s, g: inverse.im * v_m_s * v_m_s, omega_rad_s: kappa * v_m_s })
        };
        let mut roots: Vec<KRoot> = all.iter().filter_map(root).collect();
        roots.sort_by(|a, b| a.v_m_s.total_cmp(&b.v_m_s));
        Ok(roots)
    }
}
