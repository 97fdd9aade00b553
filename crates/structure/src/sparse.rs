//! Symmetric sparse matrices, and their products and parts.

mod sums;

pub(crate) use sums::{Lower, Mirrored, Pattern, Values};

use faer::reborrow::ReborrowMut as _;
use faer::sparse::{SparseColMat, SparseColMatRef, SymbolicSparseColMat, SymbolicSparseColMatRef, Triplet};
use faer::{Mat, MatMut, MatRef};
use nalgebra::DMatrix;
use rayon::prelude::*;

/// Sparse matrix of this crate.
pub(crate) type Sparse = SparseColMat<usize, f64>;

/// A mass with another added over some motions; `None` where the stiffness has no entry (`joined`) for one.
pub(crate) fn with_sum(
    m: &Sparse,
    dofs: &[usize],
    change: &DMatrix<f64>,
    joined: impl Fn(usize, usize) -> bool,
) -> Option<Sparse> {
    let pairs = || {
        dofs.iter()
            .enumerate()
            .flat_map(|(j, column)| dofs.iter().enumerate().map(move |(i, row)| ((i, j), (*row, *column))))
    };
    if !pairs().all(|(_, (row, column))| joined(row, column)) {
        return None;
    }
    let of_mass = m.triplet_iter().map(|entry| Triplet::new(entry.row, entry.col, *entry.val));
    let added = pairs().map(|(at, (row, column))| Triplet::new(row, column, change[at]));
    let all: Vec<_> = of_mass.chain(added).collect();
    let sum =
        Sparse::try_new_from_triplets(m.nrows(), m.ncols(), &all).expect("rows and columns of the mass");
    Some(without_zeros(sum.symbolic(), |at| sum.val()[at]))
}

/// Whether a matrix has an entry.
pub(crate) fn has(a: &Sparse, row: usize, column: usize) -> bool {
    a.symbolic().row_idx_of_col_raw(column).binary_search(&row).is_ok()
}

/// The values of `k + factor m` in the pattern of `k`.
///
/// # Panics
/// If `m` has an entry where `k` has none.
pub(crate) fn combine(
    k: SparseColMatRef<'_, usize, f64>,
    factor: f64,
    m: SparseColMatRef<'_, usize, f64>,
) -> Vec<f64> {
    let mut values = k.val().to_vec();
    for j in 0..m.ncols() {
        let mut places = k.symbolic().col_range(j).zip(k.symbolic().row_idx_of_col_raw(j));
        for (row, value) in m.row_idx_of_col(j).zip(m.val_of_col(j)) {
            let (place, _) =
                places.find(|(_, own)| **own == row).expect("the pattern has every entry of the mass");
            values[place] += factor * value;
        }
    }
    values
}

/// The entries of a pattern whose value, by their place in it, is not zero.
fn without_zeros(pattern: SymbolicSparseColMatRef<'_, usize>, value: impl Fn(usize) -> f64) -> Sparse {
    let (mut columns, mut rows, mut values) = (vec![0], Vec::new(), Vec::new());
    for j in 0..pattern.ncols() {
        for (at, row) in pattern.col_range(j).zip(pattern.row_idx_of_col_raw(j)) {
            let value = value(at);
            if value != 0.0 {
                rows.push(*row);
                values.push(value);
            }
        }
        columns.push(rows.len());
    }
    Sparse::new(
        SymbolicSparseColMat::new_checked(pattern.nrows(), pattern.ncols(), columns, None, rows),
        values,
    )
}

/// Rows that hang together through entries: lists of ascending rows, in the order of their first ones.
pub(crate) fn components(pattern: SymbolicSparseColMatRef<'_, usize>) -> Vec<Vec<usize>> {
    let n = pattern.ncols();
    let mut seen = vec![false; n];
    let mut components = Vec::new();
    for first in 0..n {
        if std::mem::replace(&mut seen[first], true) {
            continue;
        }
        let mut component = vec![first];
        let mut at = 0;
        while at < component.len() {
            for row in pattern.row_idx_of_col_raw(component[at]).iter().copied() {
                if !std::mem::replace(&mut seen[row], true) {
                    component.push(row);
                }
            }
            at += 1;
        }
        component.sort_unstable();
        components.push(component);
    }
    components
}

/// The rows and columns `kept` (ascending) of a matrix.
pub(crate) fn block(a: SparseColMatRef<'_, usize, f64>, kept: &[usize]) -> Sparse {
    let mut place = vec![None; a.nrows()];
    kept.iter().enumerate().for_each(|(at, row)| place[*row] = Some(at));
    let most = kept.iter().map(|column| a.symbolic().row_idx_of_col_raw(*column).len()).sum();
    let (mut columns, mut rows, mut values) = (vec![0], Vec::with_capacity(most), Vec::with_capacity(most));
    for column in kept {
        for (row, value) in a.row_idx_of_col(*column).zip(a.val_of_col(*column)) {
            if let Some(at) = place[row] {
                rows.push(at);
                values.push(*value);
            }
        }
        columns.push(rows.len());
    }
    let n = kept.len();
    Sparse::new(SymbolicSparseColMat::new_checked(n, n, columns, None, rows), values)
}

/// Columns that are worked on together: the matrix is read once for all of them.
const TOGETHER: usize = 4;

/// Numbers in the result that are worth another thread.
const SHARED: usize = 240_000;

/// `a x`; each column of the result is summed in the same order on any number of threads.
pub(crate) fn multiply(a: SparseColMatRef<'_, usize, f64>, x: MatRef<'_, f64>) -> Mat<f64> {
    // A lumped mass: to put rows side by side would take longer than the product.
    if a.val().len() <= a.ncols() {
        let mut products = Mat::zeros(a.nrows(), x.ncols());
        for (x, mut own) in x.col_iter().zip(products.col_iter_mut()) {
            for (j, factor) in x.iter().enumerate() {
                for (row, value) in a.row_idx_of_col(j).zip(a.val_of_col(j)) {
                    own[row] += value * factor;
                }
            }
        }
        return products;
    }
    by_groups(a.nrows(), x, |x, sums| {
        for (j, factor) in x.iter().enumerate().filter(|(_, factor)| **factor != [0.0; TOGETHER]) {
            for (row, value) in a.row_idx_of_col(j).zip(a.val_of_col(j)) {
                add_times(&mut sums[row], *value, factor);
            }
        }
    })
}

fn add_times(sum: &mut [f64; TOGETHER], value: f64, x: &[f64; TOGETHER]) {
    sum.iter_mut().zip(x).for_each(|(sum, x)| *sum += value * x);
}

/// A matrix of so many rows and as many columns as `x`, a group of these at a time: `add` gets the rows of `x` and adds to sums.
fn by_groups(
    rows: usize,
    x: MatRef<'_, f64>,
    add: impl Fn(&[[f64; TOGETHER]], &mut [[f64; TOGETHER]]) + Sync,
) -> Mat<f64> {
    let mut products = Mat::zeros(rows, x.ncols());
    let one_group = |(group, mut columns): (usize, MatMut<'_, f64>)| {
        let mut own = vec![[0.0; TOGETHER]; x.nrows()];
        for (at, x) in x.subcols(group * TOGETHER, columns.ncols()).col_iter().enumerate() {
            own.iter_mut().zip(x.iter()).for_each(|(own, x)| own[at] = *x);
        }
        let mut sums = vec![[0.0; TOGETHER]; rows];
        add(&own, &mut sums);
        for column in 0..columns.ncols() {
            columns.rb_mut().col_mut(column).iter_mut().zip(&sums).for_each(|(own, sum)| *own = sum[column]);
        }
    };
    if rows * x.ncols() <= SHARED {
        (0..x.ncols()).step_by(TOGETHER).for_each(|start| {
            let columns = products.subcols_mut(start, TOGETHER.min(x.ncols() - start));
            one_group((start / TOGETHER, columns));
        });
    } else {
        products.par_col_chunks_mut(TOGETHER).enumerate().for_each(one_group);
    }
    products
}

/// The diagonal.
pub(crate) fn diagonal(a: SparseColMatRef<'_, usize, f64>) -> Vec<f64> {
    (0..a.ncols())
        .map(|j| a.row_idx_of_col(j).zip(a.val_of_col(j)).filter(|(row, _)| *row == j).map(|(_, v)| *v).sum())
        .collect()
}

#[cfg(test)]
mod tests;
