//! Symmetric sparse matrices with one pattern for stiffness and mass.
//!
//! Entries are summed in the order of the elements, whatever the number of threads, and only once for both
//! triangles: the matrices are the same on every run and exactly symmetric.

use faer::reborrow::ReborrowMut as _;
use faer::sparse::{SparseColMat, SparseColMatRef, SymbolicSparseColMat, SymbolicSparseColMatRef};
use faer::{Mat, MatMut, MatRef};
use nalgebra::DMatrix;
use rayon::prelude::*;
use std::sync::Arc;

/// Sparse matrix of this crate.
pub(crate) type Sparse = SparseColMat<usize, f64>;

/// Where entries can stand in a symmetric matrix: the lower triangle, column by column, rows ascending.
#[derive(Debug, Clone)]
pub(crate) struct Pattern {
    columns: Arc<[usize]>,
    rows: Arc<[usize]>,
}

impl Pattern {
    /// Of a matrix of order `n` whose entries join the motions of each list. Every diagonal entry is in it.
    pub(crate) fn of(n: usize, lists: &[Vec<usize>]) -> Self {
        let mut users: Vec<Vec<u32>> = vec![Vec::new(); n];
        for (list, dofs) in (0_u32..).zip(lists) {
            for dof in dofs {
                users[*dof].push(list);
            }
        }
        let column = |(j, users): (usize, &Vec<u32>)| {
            let mut rows = vec![j];
            for list in users {
                rows.extend(lists[*list as usize].iter().filter(|row| **row > j));
            }
            rows.sort_unstable();
            rows.dedup();
            rows
        };
        let filled: Vec<Vec<usize>> = users.par_iter().enumerate().map(column).collect();
        let mut columns = vec![0; n + 1];
        for (j, rows) in filled.iter().enumerate() {
            columns[j + 1] = columns[j] + rows.len();
        }
        Self { columns: columns.into(), rows: filled.concat().into() }
    }

    /// The matrices with this pattern, zero so far.
    pub(crate) fn values(self) -> Values {
        let count = self.rows.len();
        Values { pattern: self, k: vec![0.0; count], m: vec![0.0; count] }
    }
}

/// Stiffness and mass of one pattern, while they are summed.
pub(crate) struct Values {
    pattern: Pattern,
    k: Vec<f64>,
    m: Vec<f64>,
}

impl Values {
    /// Adds matrices over `dofs`.
    pub(crate) fn add(&mut self, dofs: &[usize], k: Option<&DMatrix<f64>>, m: Option<&DMatrix<f64>>) {
        self.add_pairs(dofs.iter().copied().enumerate().collect(), k, m);
    }

    /// Adds those rows and columns of matrices that have a place.
    pub(crate) fn add_where(
        &mut self,
        places: &[Option<usize>],
        k: Option<&DMatrix<f64>>,
        m: Option<&DMatrix<f64>>,
    ) {
        let pairs = places.iter().enumerate().filter_map(|(i, place)| place.map(|place| (i, place)));
        self.add_pairs(pairs.collect(), k, m);
    }

    /// Adds one entry of the lower triangle, `row` >= `column`, which the pattern has.
    pub(crate) fn add_entry(&mut self, row: usize, column: usize, [k, m]: [f64; 2]) {
        let start = self.pattern.columns[column];
        let rows = &self.pattern.rows[start..self.pattern.columns[column + 1]];
        let entry = start + rows.binary_search(&row).expect("the pattern has the entry");
        self.k[entry] += k;
        self.m[entry] += m;
    }

    fn add_pairs(
        &mut self,
        mut pairs: Vec<(usize, usize)>,
        k: Option<&DMatrix<f64>>,
        m: Option<&DMatrix<f64>>,
    ) {
        pairs.sort_by_key(|(_, dof)| *dof);
        for (at, (j, column)) in pairs.iter().enumerate() {
            let range = self.pattern.columns[*column]..self.pattern.columns[column + 1];
            let rows = &self.pattern.rows[range.clone()];
            let mut place = 0;
            for (i, row) in &pairs[at..] {
                place += rows[place..].binary_search(row).expect("the pattern has every entry of an element");
                let entry = range.start + place;
                if let Some(k) = k {
                    self.k[entry] += k[(*i, *j)];
                }
                if let Some(m) = m {
                    self.m[entry] += m[(*i, *j)];
                }
            }
        }
    }

    /// Both matrices with both triangles, the mass without entries that are zero: a lumped mass has a few in each column where
    /// the stiffness has dozens.
    pub(crate) fn symmetric(self) -> (Sparse, Sparse) {
        let both = Mirrored::of(&self.pattern);
        let m = without_zeros(both.symbolic(), |at| self.m[both.source[at]]);
        (both.matrix(&self.k), m)
    }

    /// The stiffness alone, for which both triangles are known already.
    pub(crate) fn stiffness(self, both: &Mirrored) -> Sparse {
        both.matrix(&self.k)
    }
}

/// Both triangles of a pattern, and where in it their values stand.
#[derive(Debug, Clone)]
pub(crate) struct Mirrored {
    symbolic: SymbolicSparseColMat<usize>,
    source: Vec<usize>,
}

impl Mirrored {
    pub(crate) fn of(pattern: &Pattern) -> Self {
        let Pattern { columns, rows } = pattern;
        let n = columns.len() - 1;
        let mut counts = vec![0; n + 1];
        for j in 0..n {
            for row in &rows[columns[j]..columns[j + 1]] {
                counts[j + 1] += 1;
                if *row != j {
                    counts[row + 1] += 1;
                }
            }
        }
        for j in 0..n {
            counts[j + 1] += counts[j];
        }
        let mut next = counts.clone();
        let mut full = vec![0; counts[n]];
        let mut source = vec![0; counts[n]];
        // The upper triangle first, from columns in ascending order, then the lower one: rows ascend.
        for upper in [true, false] {
            for j in 0..n {
                let entries = columns[j]..columns[j + 1];
                for (entry, below) in entries.clone().zip(&rows[entries]) {
                    let (row, column) = if upper { (j, *below) } else { (*below, j) };
                    if upper && row == column {
                        continue;
                    }
                    full[next[column]] = row;
                    source[next[column]] = entry;
                    next[column] += 1;
                }
            }
        }
        Self { symbolic: SymbolicSparseColMat::new_checked(n, n, counts, None, full), source }
    }

    /// Of the matrix alone.
    pub(crate) fn symbolic(&self) -> SymbolicSparseColMatRef<'_, usize> {
        self.symbolic.as_ref()
    }

    /// The matrix of the pattern's values.
    fn matrix(&self, values: &[f64]) -> Sparse {
        let all: Vec<f64> = self.source.iter().map(|entry| values[*entry]).collect();
        Sparse::new(self.symbolic.clone(), all)
    }
}

/// A mass with another added over some motions; `None` where the stiffness `k` has no entry for one.
pub(crate) fn with_sum(m: &Sparse, dofs: &[usize], change: &DMatrix<f64>, k: &Sparse) -> Option<Sparse> {
    let mut values = vec![0.0; k.val().len()];
    add(&mut values, k.symbolic(), 1.0, m.as_ref());
    for (j, column) in dofs.iter().enumerate() {
        let range = k.symbolic().col_range(*column);
        let rows = k.symbolic().row_idx_of_col_raw(*column);
        for (i, row) in dofs.iter().enumerate() {
            values[range.start + rows.binary_search(row).ok()?] += change[(i, j)];
        }
    }
    Some(without_zeros(k.symbolic(), |at| values[at]))
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
    add(&mut values, k.symbolic(), factor, m);
    values
}

/// Adds `factor m` to the values of a pattern that has all of its entries.
fn add(
    values: &mut [f64],
    pattern: SymbolicSparseColMatRef<'_, usize>,
    factor: f64,
    m: SparseColMatRef<'_, usize, f64>,
) {
    for j in 0..m.ncols() {
        let mut places = pattern.col_range(j).zip(pattern.row_idx_of_col_raw(j));
        for (row, value) in m.row_idx_of_col(j).zip(m.val_of_col(j)) {
            let (place, _) =
                places.find(|(_, own)| **own == row).expect("the pattern has every entry of the mass");
            values[place] += factor * value;
        }
    }
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
    let (mut columns, mut rows, mut values) = (vec![0], Vec::new(), Vec::new());
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

/// `a x`; each column of the result is summed in the same order on any number of threads.
pub(crate) fn multiply(a: SparseColMatRef<'_, usize, f64>, x: MatRef<'_, f64>) -> Mat<f64> {
    let mut products = Mat::zeros(a.nrows(), x.ncols());
    let one_group = |(group, mut columns): (usize, MatMut<'_, f64>)| {
        let x = x.subcols(group * TOGETHER, columns.ncols());
        let mut sums = vec![[0.0; TOGETHER]; a.nrows()];
        for j in 0..a.ncols() {
            let mut factor = [0.0; TOGETHER];
            factor.iter_mut().zip(x.row(j).iter()).for_each(|(factor, x)| *factor = *x);
            if factor == [0.0; TOGETHER] {
                continue;
            }
            for (row, value) in a.row_idx_of_col(j).zip(a.val_of_col(j)) {
                for (sum, factor) in sums[row].iter_mut().zip(factor) {
                    *sum += value * factor;
                }
            }
        }
        for column in 0..columns.ncols() {
            columns.rb_mut().col_mut(column).iter_mut().zip(&sums).for_each(|(own, sum)| *own = sum[column]);
        }
    };
    products.par_col_chunks_mut(TOGETHER).enumerate().for_each(one_group);
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
