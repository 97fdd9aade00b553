//! The aeroelastic equations of a p-k solution (Rodden and Johnson, *MSC/NASTRAN Aeroelastic Analysis User's Guide*, 1994,
//! ch. 2; Rodden, Harder and Bellinger 1979).
//!
//! ```text
//! F(p, kappa) u = [M p² + C p + K - q (Re Q(kappa) + p/(kappa V) Im Q(kappa))] u = 0,   Im p = kappa V
//! ```
//! p in 1/s, kappa = omega/V in 1/m. On the imaginary axis this is the exact equation of oscillation; away from it the
//! imaginary part of Q damps in proportion to p, as in Nastran. A steady root (kappa = 0) takes the limit of Im Q/kappa, and beyond the
//! forces' range those of its end are held ([`GeneralisedForces::split`]).

use super::{FlutterError, GeneralisedForces, SplitForces};
use aero::Flow;
use faer::linalg::solvers::Solve;
use faer::{Mat, MatRef, c64};
use structure::unsymmetric::eigenvalues;

/// A root slower than this share of the slowest mode with a stiffness is as good as at rest.
const AT_REST: f64 = 1e-3;

/// Mass, damping, stiffness and air forces of a structure in generalised coordinates, any consistent units.
pub struct Aeroelastic<'a> {
    mass: Mat<f64>,
    damping: Mat<f64>,
    stiffness: Mat<f64>,
    forces: &'a dyn GeneralisedForces,
    slowest_rad_s: f64,
}

impl<'a> Aeroelastic<'a> {
    /// From square matrices of one size; the damping is that of the structure (zero matrix for none).
    ///
    /// # Errors
    /// If sizes differ, a number is not finite, or natural frequencies cannot be computed.
    pub fn new(
        mass: Mat<f64>,
        damping: Mat<f64>,
        stiffness: Mat<f64>,
        forces: &'a dyn GeneralisedForces,
    ) -> Result<Self, FlutterError> {
        let expected = forces.size();
        for (what, matrix) in [("the mass", &mass), ("the damping", &damping), ("the stiffness", &stiffness)]
        {
            let (rows, columns) = (matrix.nrows(), matrix.ncols());
            if (rows, columns) != (expected, expected) {
                return Err(FlutterError::Size { what, rows, columns, expected });
            }
            if let Some(value) = matrix.col_iter().flat_map(|c| c.iter().copied()).find(|v| !v.is_finite()) {
                return Err(FlutterError::Number { what, value, expected: "finite" });
            }
        }
        let slowest_rad_s = slowest_rad_s(mass.as_ref(), stiffness.as_ref())?;
        Ok(Self { mass, damping, stiffness, forces, slowest_rad_s })
    }

    /// Modes of mass one: natural frequencies in rad/s and one damping ratio for all.
    ///
    /// # Errors
    /// As [`Aeroelastic::new`].
    pub fn of_modes(
        omega_rad_s: &[f64],
        damping_ratio: f64,
        forces: &'a dyn GeneralisedForces,
    ) -> Result<Self, FlutterError> {
        let n = omega_rad_s.len();
        let diagonal = |value: &dyn Fn(f64) -> f64| {
            Mat::from_fn(n, n, |i, j| if i == j { value(omega_rad_s[i]) } else { 0.0 })
        };
        Self::new(
            diagonal(&|_| 1.0),
            diagonal(&|omega| 2.0 * damping_ratio * omega),
            diagonal(&|omega| omega * omega),
            forces,
        )
    }

    /// Number of coordinates.
    pub fn size(&self) -> usize {
        self.mass.nrows()
    }

    /// Mass.
    pub fn mass(&self) -> MatRef<'_, f64> {
        self.mass.as_ref()
    }

    /// Damping of the structure.
    pub fn damping(&self) -> MatRef<'_, f64> {
        self.damping.as_ref()
    }

    /// Stiffness.
    pub fn stiffness(&self) -> MatRef<'_, f64> {
        self.stiffness.as_ref()
    }

    /// Frequency of the slowest mode in a vacuum that has a stiffness, rad/s; one if there is none.
    pub(super) fn slowest_rad_s(&self) -> f64 {
        self.slowest_rad_s
    }

    /// Modulus below which a root is as good as at rest, 1/s.
    pub(super) fn at_rest_rad_s(&self) -> f64 {
        AT_REST * self.slowest_rad_s
    }

    /// What a distance from a root is measured by, 1/s: its modulus, but no less than that of a root at rest, since a real root
    /// goes through zero at divergence.
    pub(super) fn modulus(&self, p: c64) -> f64 {
        p.norm().max(self.at_rest_rad_s())
    }

    /// The air forces.
    pub fn forces(&self) -> &dyn GeneralisedForces {
        self.forces
    }

    /// The forces at kappa, any.
    pub(super) fn split(&self, kappa: f64, v_m_s: f64) -> Result<SplitForces, FlutterError> {
        self.forces.split(kappa, v_m_s)
    }

    /// F(p, kappa) with the air forces multiplied by `share`.
    pub(super) fn matrix(&self, p: c64, forces: &SplitForces, flow: Flow, share: f64) -> Mat<c64> {
        let (q_pa, v) = (share * flow.dynamic_pressure_pa(), flow.v_m_s);
        Mat::from_fn(self.size(), self.size(), |i, j| {
            let real = self.stiffness[(i, j)] - q_pa * forces.real[(i, j)];
            let rate = self.damping[(i, j)] - q_pa / v * forces.damping[(i, j)];
            p * p * self.mass[(i, j)] + p * rate + real
        })
    }

    /// dF/dp at fixed kappa, as [`Aeroelastic::matrix`].
    pub(super) fn slope(&self, p: c64, forces: &SplitForces, flow: Flow, share: f64) -> Mat<c64> {
        let rate = share * flow.dynamic_pressure_pa() / flow.v_m_s;
        Mat::from_fn(self.size(), self.size(), |i, j| {
            p * 2.0 * self.mass[(i, j)] + self.damping[(i, j)] - rate * forces.damping[(i, j)]
        })
    }
}

/// Frequency of the slowest mode that has a stiffness, rad/s; one if there is none.
fn slowest_rad_s(mass: MatRef<'_, f64>, stiffness: MatRef<'_, f64>) -> Result<f64, FlutterError> {
    let squares = eigenvalues(mass.partial_piv_lu().solve(stiffness).as_ref())
        .ok_or(FlutterError::Eigenvalues("the structure"))?;
    let largest = squares.iter().map(|square| square.re).fold(0.0, f64::max);
    let slowest =
        squares.iter().map(|square| square.re).filter(|s| *s > 1e-9 * largest).fold(f64::INFINITY, f64::min);
    Ok(if slowest.is_finite() { slowest.sqrt() } else { 1.0 })
}

#[cfg(test)]
mod laws;
#[cfg(test)]
mod tests;
