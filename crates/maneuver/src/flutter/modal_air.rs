//! Air forces of the doublet lattice on boxes that move with generalised coordinates.
//!
//! A motion is two rows a box, as splines give them: h along the normal at the box's midpoint (m) and theta nose up (rad).
//! ```text
//! w_j = theta_j + i (omega/V) (theta_j c_j/4 - h_j)      P_k = (W_F S cp, W_M S cp c/4)      Q = motionᵀ P_k
//! ```

use super::{FlutterError, GafTable};
use aero::{Corrections, DoubletLattice, Integration, Lattice};
use faer::{Mat, MatRef, c64};

/// Incidence of moving boxes at their three-quarter points, rad per unit of each coordinate, at omega/V.
pub fn incidence_of_motion(lattice: &Lattice, motion: MatRef<'_, f64>, omega_over_v: f64) -> Mat<c64> {
    Mat::from_fn(lattice.len(), motion.ncols(), |j, mode| {
        let (h, theta) = (motion[(2 * j, mode)], motion[(2 * j + 1, mode)]);
        c64::new(theta, omega_over_v * (0.25 * lattice.boxes[j].chord_m() * theta - h))
    })
}

/// Generalised forces per unit dynamic pressure of pressure coefficients, rows by the coordinates of `motion`. The
/// corrections have an entry for each box of the lattice.
pub fn generalised_forces(
    integration: &Integration,
    motion: MatRef<'_, f64>,
    cp: MatRef<'_, c64>,
    corrections: Option<&Corrections>,
) -> Mat<c64> {
    Mat::from_fn(motion.ncols(), cp.ncols(), |mode, column| {
        let each = (0..cp.nrows()).map(|j| {
            let (force, moment) = corrections.map_or((1.0, 1.0), |c| (c.force[j], c.moment[j]));
            let work = force * motion[(2 * j, mode)]
                + moment * integration.moment_arm(j) * motion[(2 * j + 1, mode)];
            cp[(j, column)] * (integration.area(j) * work)
        });
        each.sum()
    })
}

/// The table of generalised forces of moving boxes at rising frequencies omega/V, 1/m.
///
/// # Errors
/// If the lattice cannot be solved at a frequency, or the frequencies do not rise.
pub fn gaf_table(
    lattice: &Lattice,
    doublets: &DoubletLattice,
    motion: MatRef<'_, f64>,
    corrections: Option<&Corrections>,
    omega_over_v: &[f64],
) -> Result<GafTable, FlutterError> {
    let integration = Integration::new(lattice);
    let mut matrices = Vec::with_capacity(omega_over_v.len());
    for &kappa in omega_over_v {
        let cp = doublets.at(kappa)?.pressures(incidence_of_motion(lattice, motion, kappa).as_ref());
        matrices.push(generalised_forces(&integration, motion, cp.as_ref(), corrections));
    }
    GafTable::new(omega_over_v.to_vec(), matrices)
}
