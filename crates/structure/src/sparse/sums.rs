//! Stiffness and mass of one pattern while they are summed.
//!
//! Entries are summed in the order of the elements, whatever the number of threads, and only once for both
//! triangles: the matrices are the same on every run and exactly symmetric.

use super::{Sparse, add_times, by_groups};
use faer::sparse::{SymbolicSparseColMat, SymbolicSparseColMatRef};
use faer::{Mat, MatRef};
use nalgebra::DMatrix;
use std::sync::Arc;

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
        let (mut columns, mut rows, mut column) = (vec![0], Vec::new(), Vec::new());
        for (j, own) in users.iter().enumerate() {
            let (before, start) = (columns[j.saturating_sub(1)], rows.len());
            // Motions of one grid are in the same lists: what joins one joins the next, but for the one before.
            if j > 0 && *own == users[j - 1] && rows.get(before + 1) == Some(&j) {
                rows.extend_from_within(before + 1..start);
            } else {
                let below = own.iter().flat_map(|list| &lists[*list as usize]).filter(|row| **row > j);
                column.clear();
                column.push(j);
                column.extend(below);
                column.sort_unstable();
                column.dedup();
                rows.extend_from_slice(&column);
            }
            columns.push(rows.len());
        }
        Self { columns: columns.into(), rows: rows.into() }
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
                // A lumped mass has little but zeros.
                if let Some(m) = m.map(|m| m[(*i, *j)]).filter(|m| *m != 0.0) {
                    self.m[entry] += m;
                }
            }
        }
    }

    /// Both matrices with both triangles, the mass without entries that are zero: a lumped mass has a few in each column where
    /// the stiffness has dozens.
    pub(crate) fn symmetric(self) -> (Sparse, Sparse) {
        let (k, m) = self.lower();
        (k.symmetric(), m.symmetric())
    }

    /// Both matrices by their lower triangles, the mass without entries that are zero.
    pub(crate) fn lower(self) -> (Lower, Lower) {
        let Self { pattern, k, m } = self;
        let mass = Lower::without_zeros(&pattern, &m);
        (Lower { pattern, values: k }, mass)
    }

    /// The stiffness alone, for which both triangles are known already.
    pub(crate) fn stiffness(self, both: &Mirrored) -> Sparse {
        both.matrix(&self.k)
    }
}

/// A symmetric matrix by its lower triangle: half of the memory, for what is multiplied at most.
#[derive(Debug, Clone)]
pub(crate) struct Lower {
    pattern: Pattern,
    values: Vec<f64>,
}

impl Lower {
    fn without_zeros(pattern: &Pattern, values: &[f64]) -> Self {
        let count = values.iter().filter(|value| **value != 0.0).count();
        let (mut columns, mut rows, mut kept) =
            (vec![0], Vec::with_capacity(count), Vec::with_capacity(count));
        for range in pattern.columns.windows(2).map(|ends| ends[0]..ends[1]) {
            for (row, value) in pattern.rows[range.clone()].iter().zip(&values[range]) {
                if *value != 0.0 {
                    rows.push(*row);
                    kept.push(*value);
                }
            }
            columns.push(rows.len());
        }
        Self { pattern: Pattern { columns: columns.into(), rows: rows.into() }, values: kept }
    }

    /// Number of rows.
    pub(crate) fn order(&self) -> usize {
        self.pattern.columns.len() - 1
    }

    pub(crate) fn values(&self) -> &[f64] {
        &self.values
    }

    /// Whether there is an entry.
    pub(crate) fn has(&self, i: usize, j: usize) -> bool {
        let (column, row) = (i.min(j), i.max(j));
        let range = self.pattern.columns[column]..self.pattern.columns[column + 1];
        self.pattern.rows[range].binary_search(&row).is_ok()
    }

    /// Both triangles.
    pub(crate) fn symmetric(&self) -> Sparse {
        self.block(&(0..self.order()).collect::<Vec<_>>())
    }

    /// Both triangles of the rows and columns `kept` (ascending).
    pub(crate) fn block(&self, kept: &[usize]) -> Sparse {
        const LEFT: usize = usize::MAX;
        let mut place = vec![LEFT; self.order()];
        kept.iter().enumerate().for_each(|(at, row)| place[*row] = at);
        let column = |at: usize| {
            let range = self.pattern.columns[kept[at]]..self.pattern.columns[kept[at] + 1];
            let places = self.pattern.rows[range.clone()].iter().map(|row| place[*row]);
            places.zip(self.values[range].iter().copied()).filter(|(row, _)| *row != LEFT)
        };
        let (symbolic, values) = mirrored(kept.len(), column);
        Sparse::new(symbolic, values)
    }

    /// The product with `x`; each column of it is summed in the same order on any number of threads.
    pub(crate) fn multiply(&self, x: MatRef<'_, f64>) -> Mat<f64> {
        let n = self.order();
        by_groups(n, x, |x, sums| {
            for j in 0..n {
                let mut own = sums[j];
                let range = self.pattern.columns[j]..self.pattern.columns[j + 1];
                for (row, value) in self.pattern.rows[range.clone()].iter().zip(&self.values[range]) {
                    add_times(&mut own, *value, &x[*row]);
                    if *row != j {
                        add_times(&mut sums[*row], *value, &x[j]);
                    }
                }
                sums[j] = own;
            }
        })
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
        let column = |j: usize| {
            let entries = columns[j]..columns[j + 1];
            rows[entries.clone()].iter().copied().zip(entries)
        };
        let (symbolic, source) = mirrored(columns.len() - 1, column);
        Self { symbolic, source }
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

/// Both triangles of a symmetric matrix of order `n`, what stands in them by the columns of the lower one (row, item).
fn mirrored<T: Copy + Default, C: Iterator<Item = (usize, T)>>(
    n: usize,
    column: impl Fn(usize) -> C,
) -> (SymbolicSparseColMat<usize>, Vec<T>) {
    let mut columns = vec![0; n + 1];
    for j in 0..n {
        for (row, _) in column(j) {
            columns[j + 1] += 1;
            if row != j {
                columns[row + 1] += 1;
            }
        }
    }
    for j in 0..n {
        columns[j + 1] += columns[j];
    }
    let mut next = columns.clone();
    let (mut rows, mut items) = (vec![0; columns[n]], vec![T::default(); columns[n]]);
    let mut put = |row: usize, column: usize, item: T| {
        rows[next[column]] = row;
        items[next[column]] = item;
        next[column] += 1;
    };
    // The upper triangle first, from columns in ascending order, then the lower one: rows ascend.
    for j in 0..n {
        column(j).filter(|(row, _)| *row != j).for_each(|(row, item)| put(j, row, item));
    }
    for j in 0..n {
        column(j).for_each(|(row, item)| put(row, j, item));
    }
    (SymbolicSparseColMat::new_checked(n, n, columns, None, rows), items)
}
