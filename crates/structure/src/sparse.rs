//! Symmetric sparse matrices with one pattern for stiffness and mass.
//!
//! Entries are summed in the order of the elements, whatever the number of threads, and only once for both
//! triangles: the matrices are the same on every run and exactly symmetric.

use faer::sparse::{SparseColMat, SparseColMatRef, Triplet};
use faer::{Mat, MatRef};

/// Sparse matrix of this crate.
pub(crate) type Sparse = SparseColMat<usize, f64>;

/// One entry of the lower triangle (row >= column): place, stiffness, mass.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Entry {
    pub(crate) row: usize,
    pub(crate) column: usize,
    pub(crate) k: f64,
    pub(crate) m: f64,
}

/// Stiffness and mass of order `n` from entries of the lower triangle; entries at one place are added in the
/// order given. Both get the same pattern, with every diagonal entry in it.
pub(crate) fn pair(n: usize, mut entries: Vec<Entry>) -> (Sparse, Sparse) {
    entries.extend((0..n).map(|row| Entry { row, column: row, k: 0.0, m: 0.0 }));
    // A stable sort: equal places keep the order of the elements.
    entries.sort_by_key(|entry| (entry.column, entry.row));
    let mut merged: Vec<Entry> = Vec::with_capacity(entries.len());
    for entry in entries {
        match merged.last_mut() {
            Some(last) if last.row == entry.row && last.column == entry.column => {
                last.k += entry.k;
                last.m += entry.m;
            }
            _ => merged.push(entry),
        }
    }
    let build = |value: fn(&Entry) -> f64| {
        let mut triplets = Vec::with_capacity(2 * merged.len());
        for entry in &merged {
            triplets.push(Triplet::new(entry.row, entry.column, value(entry)));
            if entry.row != entry.column {
                triplets.push(Triplet::new(entry.column, entry.row, value(entry)));
            }
        }
        Sparse::try_new_from_triplets(n, n, &triplets).expect("rows and columns are below n")
    };
    (build(|entry| entry.k), build(|entry| entry.m))
}

/// `a + factor b` for matrices of one pattern.
pub(crate) fn combine(
    a: SparseColMatRef<'_, usize, f64>,
    factor: f64,
    b: SparseColMatRef<'_, usize, f64>,
) -> Sparse {
    let values = a.val().iter().zip(b.val()).map(|(a, b)| a + factor * b).collect();
    Sparse::new(a.symbolic().to_owned().expect("memory for a copy of the pattern"), values)
}

/// `a x`, one column after the other.
pub(crate) fn multiply(a: SparseColMatRef<'_, usize, f64>, x: MatRef<'_, f64>) -> Mat<f64> {
    let mut product = Mat::zeros(a.nrows(), x.ncols());
    for column in 0..x.ncols() {
        for j in 0..a.ncols() {
            let factor = x[(j, column)];
            if factor != 0.0 {
                for (row, value) in a.row_idx_of_col(j).zip(a.val_of_col(j)) {
                    product[(row, column)] += value * factor;
                }
            }
        }
    }
    product
}

/// The diagonal.
pub(crate) fn diagonal(a: SparseColMatRef<'_, usize, f64>) -> Vec<f64> {
    (0..a.ncols())
        .map(|j| a.row_idx_of_col(j).zip(a.val_of_col(j)).filter(|(row, _)| *row == j).map(|(_, v)| *v).sum())
        .collect()
}
