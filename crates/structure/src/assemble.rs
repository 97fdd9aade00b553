//! Sums the elements into the stiffness and mass of the whole, and reduces them to the free motions.

use crate::dofs::DofMap;
use crate::model::Model;
use crate::sparse::{self, Entry, Sparse};
use faer::sparse::SparseColMatRef;
use nalgebra::DMatrix;
use std::borrow::Cow;

/// Stiffness and mass of the g-set.
pub(crate) fn global(model: &Model) -> (Sparse, Sparse) {
    let mut entries = Vec::new();
    for element in model.elements() {
        let dofs = element.dofs();
        let (stiffness, mass) = (element.stiffness(), element.mass());
        let value = |matrix: &Option<Cow<'_, DMatrix<f64>>>, i, j| {
            matrix.as_ref().map_or(0.0, |matrix| matrix[(i, j)])
        };
        for (j, column) in dofs.iter().enumerate() {
            for (i, row) in dofs.iter().enumerate().filter(|(_, row)| *row >= column) {
                let (k, m) = (value(&stiffness, i, j), value(&mass, i, j));
                if k != 0.0 || m != 0.0 {
                    entries.push(Entry { row: *row, column: *column, k, m });
                }
            }
        }
    }
    sparse::pair(6 * model.nodes.len(), entries)
}

/// T^T K T and T^T M T for matrices of one pattern.
pub(crate) fn reduced(
    k: SparseColMatRef<'_, usize, f64>,
    m: SparseColMatRef<'_, usize, f64>,
    dofs: &DofMap,
) -> (Sparse, Sparse) {
    let mut entries = Vec::with_capacity(k.val().len());
    for j in 0..k.ncols() {
        for ((i, k), m) in k.row_idx_of_col(j).zip(k.val_of_col(j)).zip(m.val_of_col(j)) {
            for (row, left) in &dofs.rows[i] {
                for (column, right) in &dofs.rows[j] {
                    if row >= column {
                        let factor = left * right;
                        entries.push(Entry { row: *row, column: *column, k: factor * k, m: factor * m });
                    }
                }
            }
        }
    }
    sparse::pair(dofs.free.len(), entries)
}
