//! The vortex lattice: influence matrix A with w = A cp, and its factorisation.
//!
//! Each box carries a horseshoe with its bound vortex on the quarter line and circulation `V cp chord/2`
//! (Kutta-Joukowski); the stream goes along the box at the three-quarter point at mid-strip. Compressibility is
//! Prandtl and Glauert's: x is divided by beta = sqrt(1 - Mach^2), while cp, chords and normals stay.

use crate::error::AeroError;
use crate::horseshoe::{Receivers, horseshoes, horseshoes_on_surfaces};
use crate::lattice::Lattice;
use crate::mirror::{MirrorPlane, silence};
use crate::seams::Seams;
use crate::strip_vortices::add_strips;
use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::lu::partial_pivoting::{factor, solve};
use faer::perm::Perm;
use faer::{Mat, MatMut, MatRef, Spec, get_global_parallelism};
use rayon::prelude::*;

/// The influence matrix A, n by n: incidence `w_i` (positive nose up with respect to the normal) that box i needs for
/// the pressure coefficients `cp_j` (positive along the normals): w = A cp.
///
/// # Errors
/// If the lattice is empty, meets the plane of symmetry, or the Mach number is not in 0..1.
pub fn influence(lattice: &Lattice, plane: MirrorPlane, mach: f64) -> Result<Mat<f64>, AeroError> {
    plane.check(lattice)?;
    let mut matrix = influence_of_own(lattice, mach)?;
    if let Some((y_m, sign)) = plane.image() {
        add(&mut matrix, lattice, mach, Some(y_m), sign);
    }
    silence(&mut matrix, &plane.silent(lattice));
    Ok(matrix)
}

/// The influence matrix of boxes that a wing carries: vortices run along the corners that they share (`seams`, of the lattice as it
/// was laid out), and legs leave from the trailing edge of their strip. At the root boxes may turn a little across the plane,
/// so their side of it is not checked.
///
/// # Errors
/// If the lattice is empty or the Mach number is not in 0..1.
///
/// # Panics
/// If the seams are those of other boxes.
pub fn influence_of_moved(
    lattice: &Lattice,
    seams: &Seams,
    plane: MirrorPlane,
    mach: f64,
) -> Result<Mat<f64>, AeroError> {
    check(lattice, mach)?;
    let vortices = horseshoes_on_surfaces(lattice, &seams.closed(lattice), beta(mach));
    let mut matrix = Mat::zeros(lattice.len(), lattice.len());
    let mut add = |plane, factor| {
        // A column of a new matrix is contiguous.
        let columns = matrix.col_iter_mut();
        let columns = columns.filter_map(|column| Some(column.try_as_col_major_mut()?.as_slice_mut()));
        add_strips(columns.collect(), &vortices, &Receivers::new(lattice, beta(mach), plane), factor);
    };
    add(None, 1.0);
    if let Some((y_m, sign)) = plane.image() {
        add(Some(y_m), sign);
    }
    Ok(matrix)
}

/// The influence matrix without an image.
///
/// # Errors
/// If the lattice is empty or the Mach number is not in 0..1.
pub(crate) fn influence_of_own(lattice: &Lattice, mach: f64) -> Result<Mat<f64>, AeroError> {
    check(lattice, mach)?;
    let mut matrix = Mat::zeros(lattice.len(), lattice.len());
    add(&mut matrix, lattice, mach, None, 1.0);
    Ok(matrix)
}

pub(crate) fn check(lattice: &Lattice, mach: f64) -> Result<(), AeroError> {
    if !(0.0..1.0).contains(&mach) {
        return Err(AeroError::Mach { mach });
    }
    if lattice.is_empty() {
        return Err(AeroError::Empty);
    }
    Ok(())
}

/// Of Prandtl and Glauert.
pub(crate) fn beta(mach: f64) -> f64 {
    (1.0 - mach * mach).sqrt()
}

/// The influence of the lattice's mirror image about y = `y_m` alone.
pub(crate) fn influence_of_image(lattice: &Lattice, mach: f64, y_m: f64) -> Mat<f64> {
    let mut matrix = Mat::zeros(lattice.len(), lattice.len());
    add(&mut matrix, lattice, mach, Some(y_m), 1.0);
    matrix
}

/// Adds `factor` times the influence of the lattice on itself, or of its image about a plane.
fn add(matrix: &mut Mat<f64>, lattice: &Lattice, mach: f64, plane: Option<f64>, factor: f64) {
    let receivers = Receivers::new(lattice, beta(mach), plane);
    let vortices = horseshoes(lattice, beta(mach));
    matrix.par_col_iter_mut().zip(vortices.par_iter()).for_each(|(column, vortex)| {
        // A column of a new matrix is contiguous.
        let Some(column) = column.try_as_col_major_mut() else { return };
        receivers.add_incidence(vortex, factor, column.as_slice_mut());
    });
}

/// The row of the first pivot that is lost in round-off, if any.
pub(crate) fn lost_pivot(sizes: &[f64]) -> Option<usize> {
    let largest = sizes.iter().fold(0.0, |a: f64, b| a.max(*b));
    sizes.iter().position(|size| !size.is_finite() || *size <= 1e-13 * largest)
}

/// The lattice solved once: pressures for any incidence.
#[derive(Debug, Clone)]
pub struct SteadyAero {
    /// L, whose diagonal is one, below U.
    factors: Mat<f64>,
    /// Which row of the influence matrix stands at each place.
    rows: Perm<usize>,
    /// Boxes that carry nothing.
    silent: Vec<usize>,
}

impl SteadyAero {
    /// Computes and factorises the influence matrix.
    ///
    /// # Errors
    /// As [`influence`], and if the matrix is singular.
    pub fn new(lattice: &Lattice, plane: MirrorPlane, mach: f64) -> Result<Self, AeroError> {
        Self::factorised(lattice, influence(lattice, plane, mach)?, plane.silent(lattice))
    }

    /// The same by [`influence_of_moved`].
    ///
    /// # Errors
    /// As that, and if the matrix is singular.
    pub fn moved(lattice: &Lattice, seams: &Seams, plane: MirrorPlane, mach: f64) -> Result<Self, AeroError> {
        Self::factorised(lattice, influence_of_moved(lattice, seams, plane, mach)?, Vec::new())
    }

    /// In the place of the matrix: faer's own type keeps two copies, which took a sixth of the processor time of a bent wing of 708 boxes.
    fn factorised(lattice: &Lattice, mut factors: Mat<f64>, silent: Vec<usize>) -> Result<Self, AeroError> {
        let (n, par) = (factors.ncols(), get_global_parallelism());
        let (mut places, mut rows) = (vec![0; n], vec![0; n]);
        let need = factor::lu_in_place_scratch::<usize, f64>(n, n, par, Spec::default());
        let stack = &mut MemBuffer::new(need);
        factor::lu_in_place(
            factors.as_mut(),
            &mut places,
            &mut rows,
            par,
            MemStack::new(stack),
            Spec::default(),
        );
        let pivots: Vec<f64> = factors.diagonal().column_vector().iter().map(|p| p.abs()).collect();
        match lost_pivot(&pivots) {
            Some(i) => Err(AeroError::Singular { id: lattice.boxes[i].id }),
            None => Ok(Self { factors, rows: Perm::new_checked(places.into(), rows.into(), n), silent }),
        }
    }

    /// Pressure coefficients cp = A^-1 w, n by columns, for incidences w in rad, n by columns.
    ///
    /// # Panics
    /// If `w` has not one row per box.
    pub fn pressures(&self, w: MatRef<'_, f64>) -> Mat<f64> {
        let (n, par) = (self.factors.ncols(), get_global_parallelism());
        let stack = &mut MemBuffer::new(solve::solve_in_place_scratch::<usize, f64>(n, w.ncols(), par));
        let (mut pressures, lu) = (w.to_owned(), self.factors.as_ref());
        solve::solve_in_place(lu, lu, self.rows.as_ref(), pressures.as_mut(), par, MemStack::new(stack));
        self.silent.iter().for_each(|at| pressures.row_mut(*at).fill(0.0));
        pressures
    }

    /// What a weighted sum of pressures weighs incidences by, A^-T c: one weight a box, of cp in, of rad out.
    ///
    /// # Panics
    /// If there is not one weight a box.
    pub fn weights_of_incidences(&self, weights: &[f64]) -> Vec<f64> {
        let mut weights = weights.to_vec();
        self.silent.iter().for_each(|at| weights[*at] = 0.0);
        let (n, par) = (weights.len(), get_global_parallelism());
        let stack = &mut MemBuffer::new(solve::solve_transpose_in_place_scratch::<usize, f64>(n, 1, par));
        let (column, lu) = (MatMut::from_column_major_slice_mut(&mut weights, n, 1), self.factors.as_ref());
        solve::solve_transpose_in_place(lu, lu, self.rows.as_ref(), column, par, MemStack::new(stack));
        weights
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_pivot_is_lost_where_it_is_no_more_than_round_off_of_the_largest() {
        assert_eq!(lost_pivot(&[2.0, 1.0, 3.0]), None);
        assert_eq!(lost_pivot(&[1e3, 1.0, 1e-9]), None);
        assert_eq!(lost_pivot(&[1e3, 1.0, 0.9e-10]), Some(2));
        assert_eq!(lost_pivot(&[1e-3, 0.9e-16, 1.0e-15]), Some(1));
        assert_eq!(lost_pivot(&[0.0, 0.0]), Some(0));
        for bad in [f64::NAN, f64::INFINITY] {
            assert_eq!(lost_pivot(&[1.0, bad, 0.0]), Some(usize::from(bad.is_nan())));
        }
        assert_eq!(lost_pivot(&[]), None);
    }
}
