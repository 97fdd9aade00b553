//! Air forces of the doublet lattice on boxes that move with generalised coordinates.
//!
//! A motion is two rows a box, as splines give them: h along the normal at the box's midpoint (m) and theta nose up (rad).
//! ```text
//! w_j = theta_j + i (omega/V) (theta_j c_j/4 - h_j)      Q = motionᵀ W S cp
//! ```
//! Box loads are those of [`aero::load_operator`] (paper 1, Eq. 7).

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

/// The table of generalised forces of moving boxes at rising frequencies omega/V, 1/m.
///
/// # Errors
/// If the lattice cannot be solved at a frequency, or the frequencies do not rise.
pub fn gaf_table(
    lattice: &Lattice,
    dlm: &DoubletLattice,
    motion: MatRef<'_, f64>,
    corrections: Option<&Corrections>,
    omega_over_v: &[f64],
) -> Result<GafTable, FlutterError> {
    let integration = Integration::new(lattice);
    let neutral = Corrections::neutral(lattice.len());
    let loads = integration.corrected(corrections.unwrap_or(&neutral));
    let mut matrices = Vec::with_capacity(omega_over_v.len());
    for &kappa in omega_over_v {
        let cp = dlm.at(kappa)?.pressures(incidence_of_motion(lattice, motion, kappa).as_ref());
        matrices.push(loads.weighed(motion.transpose(), cp.as_ref()));
    }
    GafTable::new(omega_over_v.to_vec(), matrices)
}
