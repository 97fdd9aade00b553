//! Motions that have no stiffness at their grid, which Nastran's AUTOSPC holds.
//!
//! The stiffness of a grid's free displacements, and that of its free rotations, is looked at by itself: where its weakest
//! direction has less than [`EPZERO`] of the strongest, the motion nearest to that direction is held, and so on with those that
//! are left. Loads and masses on a motion that is held are lost, so whoever runs a deck says which were.

use crate::sparse::Sparse;
use nalgebra::{DMatrix, SymmetricEigen};

/// The share of the largest stiffness of a grid below which a direction has none: Nastran's default of PARAM EPZERO.
const EPZERO: f64 = 1e-8;

/// Positions in the f-set of the motions to be held; `free` are the f-set's degrees of freedom of the g-set, ascending.
pub(crate) fn without_stiffness(k_ff: &Sparse, free: &[usize]) -> Vec<usize> {
    let mut held = Vec::new();
    for group in (0..free.len()).collect::<Vec<_>>().chunk_by(|a, b| free[*a] / 3 == free[*b] / 3) {
        let mut left = group.to_vec();
        while let Some(weak) = weakest(k_ff, &left) {
            held.push(left.remove(weak));
        }
    }
    held.sort_unstable();
    held
}

/// Which of some motions is nearest to a direction without stiffness.
fn weakest(k_ff: &Sparse, motions: &[usize]) -> Option<usize> {
    if motions.is_empty() {
        return None;
    }
    let block = DMatrix::from_fn(motions.len(), motions.len(), |i, j| entry(k_ff, motions[i], motions[j]));
    let largest = block.amax();
    if largest == 0.0 {
        return Some(0);
    }
    let eigen = SymmetricEigen::new(block / largest);
    let (at, least) = eigen.eigenvalues.argmin();
    (least < EPZERO * eigen.eigenvalues.max()).then(|| eigen.eigenvectors.column(at).iamax())
}

fn entry(k: &Sparse, row: usize, column: usize) -> f64 {
    let rows = k.symbolic().row_idx_of_col_raw(column);
    rows.binary_search(&row).map_or(0.0, |at| k.val_of_col(column)[at])
}
