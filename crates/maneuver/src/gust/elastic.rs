//! The answer of a flexible structure to oscillating loads that do not depend on its motion, in its own air forces.

use crate::flutter::{Aeroelastic, FlutterError};
use aero::Flow;
use faer::linalg::solvers::Solve;
use faer::{Mat, MatRef, c64};

/// Amplitudes of the generalised coordinates, x = (K - omega² M + i (omega C + D) - q Q)⁻¹ f, for loads f (columns), at
/// omega in rad/s. `structural` is the structure's damping D, a force proportional to displacement: g K, and what elements have of their own.
///
/// # Errors
/// If the air forces are not given at omega/V.
pub fn elastic_response(
    system: &Aeroelastic<'_>,
    flow: Flow,
    omega_rad_s: f64,
    structural: MatRef<'_, f64>,
    loads: MatRef<'_, c64>,
) -> Result<Mat<c64>, FlutterError> {
    let n = system.size();
    let q_pa = flow.dynamic_pressure_pa();
    let air = system.forces().at(omega_rad_s / flow.v_m_s, flow.v_m_s)?;
    let matrix = Mat::from_fn(n, n, |i, j| {
        let stiffness = c64::new(system.stiffness()[(i, j)], structural[(i, j)]);
        let inertia = omega_rad_s * omega_rad_s * system.mass()[(i, j)];
        stiffness - inertia + c64::new(0.0, omega_rad_s * system.damping()[(i, j)]) - air[(i, j)] * q_pa
    });
    Ok(matrix.partial_piv_lu().solve(loads))
}
