//! The panels of a factor L D L^T, and right-hand sides through them, eight side by side.
//!
//! faer's own solve takes each panel to its product of large matrices, which copies the panel first. Here an entry of the factor
//! meets the eight numbers of its row at once, four columns together, and the factor is read once on the way down and once on the way back.
#![expect(clippy::inline_always, reason = "what is inlined is compiled for the processor's widest vectors")]

use faer::MatRef;
use faer::sparse::linalg::cholesky::supernodal::SupernodalLdltRef;
use faer::sparse::linalg::cholesky::{SymbolicCholesky, SymbolicCholeskyRaw};
use pulp::{Simd, WithSimd};

/// Right-hand sides that go through the factor together.
pub(super) const TOGETHER: usize = 8;

/// What stands side by side in a row.
pub(super) type Row = [f64; TOGETHER];

/// The factor, panel by panel.
#[derive(Clone, Copy)]
pub(super) enum Panels<'a> {
    Supernodal {
        blocks: SupernodalLdltRef<'a, usize, f64>,
        count: usize,
    },
    /// What faer takes for a diagonal matrix: a panel is a column.
    Simplicial {
        columns: &'a [usize],
        rows: &'a [usize],
        values: &'a [f64],
    },
}

/// Columns of the factor with the same rows: a triangle with the pivots on its diagonal in the place of the ones of L, and the rows
/// below it.
pub(super) struct Panel<'a> {
    /// The first column's place in the order of elimination.
    pub(super) start: usize,
    pub(super) width: usize,
    values: MatRef<'a, f64>,
    /// Places of the rows below the triangle.
    pub(super) rows: &'a [usize],
}

impl<'a> Panels<'a> {
    pub(super) fn of(symbolic: &'a SymbolicCholesky<usize>, values: &'a [f64]) -> Self {
        match symbolic.raw() {
            SymbolicCholeskyRaw::Supernodal(pattern) => Self::Supernodal {
                blocks: SupernodalLdltRef::new(pattern, values),
                count: pattern.n_supernodes(),
            },
            SymbolicCholeskyRaw::Simplicial(pattern) => {
                Self::Simplicial { columns: pattern.col_ptr(), rows: pattern.row_idx(), values }
            }
        }
    }

    pub(super) fn count(&self) -> usize {
        match self {
            Self::Supernodal { count, .. } => *count,
            Self::Simplicial { columns, .. } => columns.len() - 1,
        }
    }

    #[inline(always)]
    pub(super) fn panel(&self, at: usize) -> Panel<'a> {
        match *self {
            Self::Supernodal { blocks, .. } => {
                let block = blocks.supernode(at);
                let values = block.val();
                Panel { start: block.start(), width: values.ncols(), values, rows: block.pattern() }
            }
            Self::Simplicial { columns, rows, values } => {
                let own = columns[at]..columns[at + 1];
                let values = MatRef::from_column_major_slice(&values[own.clone()], own.len(), 1);
                Panel { start: at, width: 1, values, rows: &rows[own.start + 1..own.end] }
            }
        }
    }

    /// x for L D L^T x = b, b in the place of x, both in the order of elimination.
    pub(super) fn solve(self, x: &mut [Row]) {
        pulp::Arch::new().dispatch(Through { panels: self, x });
    }
}

/// The way through the factor, compiled for each set of vector instructions.
struct Through<'a, 'x> {
    panels: Panels<'a>,
    x: &'x mut [Row],
}

impl WithSimd for Through<'_, '_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        match S::F64_LANES {
            8 => self.run::<S, 1>(simd),
            4 => self.run::<S, 2>(simd),
            2 => self.run::<S, 4>(simd),
            _ => self.run::<S, 8>(simd),
        }
    }
}

impl Through<'_, '_> {
    /// With rows of `N` vectors.
    #[inline(always)]
    fn run<S: Simd, const N: usize>(self, simd: S) {
        let (x, _) = S::as_mut_simd_f64s(self.x.as_flattened_mut());
        let (x, _) = x.as_chunks_mut::<N>();
        let mut local = Vec::new();
        for at in 0..self.panels.count() {
            self.panels.panel(at).down(simd, x, &mut local);
        }
        for at in (0..self.panels.count()).rev() {
            self.panels.panel(at).back(simd, x, &mut local);
        }
    }
}

impl<'a> Panel<'a> {
    /// The pivot, the rest of the triangle and the rows below it, in this order.
    #[inline(always)]
    pub(super) fn column(&self, at: usize) -> &'a [f64] {
        &self.values.col(at).try_as_col_major().expect("columns of a factor are contiguous").as_slice()[at..]
    }

    /// L^-1 x: the panel's own rows are known, all below lose their part of them.
    #[inline(always)]
    fn down<S: Simd, const N: usize>(&self, simd: S, x: &mut [[S::f64s; N]], local: &mut Vec<[S::f64s; N]>) {
        let own = self.start..self.start + self.width;
        local.clear();
        local.extend_from_slice(&x[own.clone()]);
        local.resize(self.width + self.rows.len(), [simd.splat_f64s(0.0); N]);
        let mut at = 0;
        while self.width - at >= 4 {
            self.take::<S, N, 4>(simd, at, local);
            at += 4;
        }
        if self.width - at >= 2 {
            self.take::<S, N, 2>(simd, at, local);
            at += 2;
        }
        if self.width > at {
            self.take::<S, N, 1>(simd, at, local);
        }
        let (first, below) = local.split_at(self.width);
        x[own].copy_from_slice(first);
        for (row, sum) in self.rows.iter().zip(below) {
            add(simd, &mut x[*row], 1.0, sum);
        }
    }

    /// Takes the parts of `G` rows, from the one at `at` on, out of all below them in the panel; the columns are read together.
    #[inline(always)]
    fn take<S: Simd, const N: usize, const G: usize>(&self, simd: S, at: usize, local: &mut [[S::f64s; N]]) {
        let (known, below) = local[at..].split_at_mut(G);
        for first in 0..G {
            let (row, rest) = known[first..].split_first_mut().expect("a row of the group");
            rest.iter_mut()
                .zip(&self.column(at + first)[1..])
                .for_each(|(other, l)| add(simd, other, -l, row));
        }
        let columns: [&[f64]; G] = std::array::from_fn(|i| &self.column(at + i)[G - i..][..below.len()]);
        // Copies, which stay in registers: a sum is written once.
        let known: [[S::f64s; N]; G] = std::array::from_fn(|i| known[i]);
        for (place, row) in below.iter_mut().enumerate() {
            let mut sum = *row;
            for (column, known) in columns.iter().zip(&known) {
                add(simd, &mut sum, -column[place], known);
            }
            *row = sum;
        }
    }

    /// L^-T D^-1 x: all rows below are known, the panel's own lose their part of them.
    #[inline(always)]
    fn back<S: Simd, const N: usize>(&self, simd: S, x: &mut [[S::f64s; N]], local: &mut Vec<[S::f64s; N]>) {
        let own = self.start..self.start + self.width;
        local.clear();
        local.extend_from_slice(&x[own.clone()]);
        local.extend(self.rows.iter().map(|row| x[*row]));
        for (at, row) in local[..self.width].iter_mut().enumerate() {
            let pivot = simd.splat_f64s(self.column(at)[0]);
            for x in row {
                *x = simd.div_f64s(*x, pivot);
            }
        }
        let mut end = self.width;
        if end % 2 == 1 {
            end -= 1;
            self.give::<S, N, 1>(simd, end, local);
        }
        if end % 4 == 2 {
            end -= 2;
            self.give::<S, N, 2>(simd, end, local);
        }
        while end > 0 {
            end -= 4;
            self.give::<S, N, 4>(simd, end, local);
        }
        x[own].copy_from_slice(&local[..self.width]);
    }

    /// Takes the parts of all rows below out of `G` rows, from the one at `at` on; the columns are read together.
    #[inline(always)]
    fn give<S: Simd, const N: usize, const G: usize>(&self, simd: S, at: usize, local: &mut [[S::f64s; N]]) {
        let (own, below) = local[at..].split_at_mut(G);
        let columns: [&[f64]; G] = std::array::from_fn(|i| &self.column(at + i)[G - i..][..below.len()]);
        let mut sums = [[simd.splat_f64s(0.0); N]; G];
        for (place, row) in below.iter().enumerate() {
            for (sum, column) in sums.iter_mut().zip(&columns) {
                add(simd, sum, column[place], row);
            }
        }
        for first in (0..G).rev() {
            let (row, known) = own[first..].split_first_mut().expect("a row of the group");
            add(simd, row, -1.0, &sums[first]);
            known.iter().zip(&self.column(at + first)[1..]).for_each(|(other, l)| add(simd, row, -l, other));
        }
    }
}

/// Adds so many times a row.
#[inline(always)]
fn add<S: Simd, const N: usize>(simd: S, sum: &mut [S::f64s; N], factor: f64, row: &[S::f64s; N]) {
    let factor = simd.splat_f64s(factor);
    for (sum, row) in sum.iter_mut().zip(row) {
        *sum = simd.mul_add_e_f64s(factor, *row, *sum);
    }
}
