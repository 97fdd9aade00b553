//! The vortex lattice: influence matrix A with w = A cp, and its factorisation.
//!
//! Each box carries a horseshoe with its bound vortex on the quarter line and circulation `V cp chord/2`
//! (Kutta-Joukowski); the stream goes along the box at the three-quarter point at mid-strip. Compressibility is
//! Prandtl and Glauert's: x is divided by beta = sqrt(1 - Mach^2), while cp, chords and normals stay.

use crate::error::AeroError;
use crate::horseshoe::{Receivers, horseshoes};
use crate::lattice::Lattice;
use crate::mirror::MirrorPlane;
use faer::linalg::solvers::{PartialPivLu, Solve};
use faer::{Mat, MatRef};
use rayon::prelude::*;

/// The influence matrix A, n by n: incidence `w_i` (positive nose up with respect to the normal) that box i needs for
/// the pressure coefficients `cp_j` (positive along the normals): w = A cp.
///
/// # Errors
/// If the lattice is empty, meets the plane of symmetry, or the Mach number is not in 0..1.
pub fn influence(lattice: &Lattice, plane: MirrorPlane, mach: f64) -> Result<Mat<f64>, AeroError> {
    if !(0.0..1.0).contains(&mach) {
        return Err(AeroError::Mach { mach });
    }
    if lattice.is_empty() {
        return Err(AeroError::Empty);
    }
    plane.check(lattice)?;
    let beta = (1.0 - mach * mach).sqrt();
    let vortices = horseshoes(lattice, beta);
    let own = Receivers::new(lattice, beta, None);
    let image = plane.image().map(|(y_m, sign)| (Receivers::new(lattice, beta, Some(y_m)), sign));
    let mut matrix = Mat::zeros(lattice.len(), lattice.len());
    matrix.par_col_iter_mut().zip(vortices.par_iter()).for_each(|(column, vortex)| {
        // A column of a new matrix is contiguous.
        let Some(column) = column.try_as_col_major_mut() else { return };
        let column = column.as_slice_mut();
        own.add_incidence(vortex, 1.0, column);
        if let Some((receivers, sign)) = &image {
            receivers.add_incidence(vortex, *sign, column);
        }
    });
    Ok(matrix)
}

/// The lattice solved once: pressures for any incidence.
#[derive(Debug, Clone)]
pub struct SteadyAero {
    factors: PartialPivLu<f64>,
}

impl SteadyAero {
    /// Computes and factorises the influence matrix.
    ///
    /// # Errors
    /// As [`influence`], and if the matrix is singular.
    pub fn new(lattice: &Lattice, plane: MirrorPlane, mach: f64) -> Result<Self, AeroError> {
        let factors = influence(lattice, plane, mach)?.partial_piv_lu();
        let pivots = factors.U().diagonal();
        let size = |i: usize| pivots[i].abs();
        let largest = (0..lattice.len()).map(size).fold(0.0, f64::max);
        let lost = |&i: &usize| !size(i).is_finite() || size(i) <= 1e-13 * largest;
        match (0..lattice.len()).find(lost) {
            Some(i) => Err(AeroError::Singular { id: lattice.boxes[i].id }),
            None => Ok(Self { factors }),
        }
    }

    /// Pressure coefficients cp = A^-1 w, n by columns, for incidences w in rad, n by columns.
    ///
    /// # Panics
    /// If `w` has not one row per box.
    pub fn pressures(&self, w: MatRef<'_, f64>) -> Mat<f64> {
        self.factors.solve(w)
    }

    /// [`SteadyAero::pressures`] for a single column.
    ///
    /// # Panics
    /// If `w` has not one entry per box.
    pub fn pressures_of(&self, w: &[f64]) -> Vec<f64> {
        let column = self.pressures(MatRef::from_column_major_slice(w, w.len(), 1));
        column.col(0).iter().copied().collect()
    }
}
