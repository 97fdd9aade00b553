//! The sparse factorisation: S A S = L D L^T with S the scaling to a unit diagonal, without pivoting (faer, supernodal, with
//! a fill-reducing order).
//!
//! Whether a motion meets stiffness at all is asked of the weakest motions, found by inverse iteration with the factor:
//! rounding the entries of A alone changes the energy x^T A x of a motion by up to eps |x|^T |A| |x|. A motion whose energy is
//! not well above this cannot be told from a loose one. It is held by a spring where it moves most, so that the
//! elimination goes on and names every further one.
//!
//! This file is the seam to faer's sparse factorisation.

use crate::blocks::{Noise, inner};
use crate::ordering::reverse_cuthill_mckee;
use crate::sparse::{self, Sparse};
use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::cholesky::ldlt::factor::LdltRegularization;
use faer::perm::PermRef;
use faer::sparse::linalg::SupernodalThreshold;
use faer::sparse::linalg::cholesky::supernodal::SupernodalLdltRef;
use faer::sparse::linalg::cholesky::{
    CholeskySymbolicParams, LdltRef, SymbolicCholesky, SymbolicCholeskyRaw, SymmetricOrdering,
    factorize_symbolic_cholesky,
};
use faer::sparse::{SparseColMatRef, SymbolicSparseColMatRef};
use faer::{Conj, Mat, MatMut, MatRef, Par, Side, Spec};
use rayon::iter::ParallelIterator;
use std::sync::Arc;

/// Scaled pivots up to this one are held at once.
const LOOSE: f64 = 1e-14;

/// The energy of a motion must exceed the effect of rounding the entries by this factor.
const MARGIN: f64 = 4.0;

/// What a loose pivot is replaced by: greater than any scaled pivot of a positive definite matrix, which is at most one.
const HELD: f64 = 2.0;

/// How many of the weakest motions are looked at together: a free body has six.
const WEAKEST: usize = 8;

/// Inverse iterations on them. A motion that meets no stiffness stands out after the first.
const ITERATIONS: usize = 3;

/// Columns that are solved together.
const TOGETHER: usize = 8;

/// The pattern of a factor in its order of elimination; the same for every matrix of one pattern.
pub(crate) type Analysis = SymbolicCholesky<usize>;

/// S A S = L D L^T with S the scaling to a unit diagonal.
#[derive(Debug)]
pub(crate) struct Factor {
    symbolic: Arc<Analysis>,
    values: Vec<f64>,
    scale: Vec<f64>,
    scaled: Sparse,
    /// Degrees of freedom at which loose motions were held ([`Factor::held`] only).
    pub(crate) loose: Vec<usize>,
}

impl Factor {
    /// Of a positive semidefinite matrix; what is loose is held and listed.
    pub(crate) fn held(analysis: &Arc<Analysis>, a: SparseColMatRef<'_, usize, f64>) -> Self {
        Self::held_expecting(analysis, a, &Mat::zeros(a.ncols(), 0))
    }

    /// As [`Factor::held`], with motions (columns) that may turn out to be loose: those that are need not be searched for,
    /// which saves a factorisation.
    pub(crate) fn held_expecting(
        analysis: &Arc<Analysis>,
        a: SparseColMatRef<'_, usize, f64>,
        expected: &Mat<f64>,
    ) -> Self {
        let mut springs = loose_among(a, expected);
        loop {
            let mut factor = Self::with_springs(analysis, a, &springs);
            let found = if factor.loose.is_empty() { factor.loose_motions() } else { factor.loose.clone() };
            let new: Vec<usize> = found.into_iter().filter(|dof| !springs.contains(dof)).collect();
            if new.is_empty() {
                factor.loose = springs;
                return factor;
            }
            springs.extend(new);
        }
    }

    /// With springs to the ground at some degrees of freedom, as stiff as what they hold.
    fn with_springs(analysis: &Arc<Analysis>, a: SparseColMatRef<'_, usize, f64>, springs: &[usize]) -> Self {
        let regularization = LdltRegularization {
            dynamic_regularization_signs: Some(&vec![1; a.ncols()]),
            dynamic_regularization_delta: HELD,
            dynamic_regularization_epsilon: LOOSE,
        };
        let mut factor = Self::new(analysis, a, &sparse::diagonal(a), springs, regularization)
            .expect("a positive pivot is put in the place of every other, and entries are finite");
        let loose = factor.pivots().into_iter().filter(|(_, pivot)| *pivot == HELD).map(|(dof, _)| dof);
        factor.loose = loose.collect();
        factor
    }

    /// Of an indefinite matrix, without pivoting; `None` if a pivot is exactly zero. `size` gives the scale of
    /// each degree of freedom.
    pub(crate) fn indefinite(
        analysis: &Arc<Analysis>,
        a: SparseColMatRef<'_, usize, f64>,
        size: &[f64],
    ) -> Option<Self> {
        Self::new(analysis, a, size, &[], LdltRegularization::default())
    }

    fn new(
        analysis: &Arc<Analysis>,
        a: SparseColMatRef<'_, usize, f64>,
        size: &[f64],
        springs: &[usize],
        regularization: LdltRegularization<'_, f64>,
    ) -> Option<Self> {
        let scale: Vec<f64> = size.iter().map(|d| if *d > 0.0 { 1.0 / d.sqrt() } else { 1.0 }).collect();
        let scaled = scaled(a, &scale, springs);
        let symbolic = Arc::clone(analysis);
        let mut values = vec![0.0; symbolic.len_val()];
        let mut memory =
            MemBuffer::new(symbolic.factorize_numeric_ldlt_scratch::<f64>(Par::Seq, Spec::default()));
        symbolic
            .factorize_numeric_ldlt(
                &mut values,
                scaled.as_ref(),
                Side::Lower,
                regularization,
                Par::Seq,
                MemStack::new(&mut memory),
                Spec::default(),
            )
            .ok()?;
        Some(Self { symbolic, values, scale, scaled, loose: Vec::new() })
    }

    /// Calls `see` for each column of L in the order of elimination: its number, pivot, and the entries below it (row in
    /// the order of elimination, value).
    fn columns(&self, mut see: impl FnMut(usize, f64, &mut dyn Iterator<Item = (usize, f64)>)) {
        match self.symbolic.raw() {
            SymbolicCholeskyRaw::Supernodal(pattern) => {
                let blocks = SupernodalLdltRef::new(pattern, &self.values);
                for block in (0..pattern.n_supernodes()).map(|block| blocks.supernode(block)) {
                    let (values, start, width) = (block.val(), block.start(), block.val().ncols());
                    // The diagonal holds the pivots in the place of the ones of L.
                    for column in 0..width {
                        let inside = (column + 1..width).map(|row| (start + row, values[(row, column)]));
                        let below = block.pattern().iter().enumerate();
                        let below = below.map(|(at, row)| (*row, values[(width + at, column)]));
                        see(start + column, values[(column, column)], &mut inside.chain(below));
                    }
                }
            }
            // What faer takes for a diagonal matrix.
            SymbolicCholeskyRaw::Simplicial(pattern) => {
                let (columns, rows) = (pattern.col_ptr(), pattern.row_idx());
                for column in 0..pattern.ncols() {
                    let below = columns[column] + 1..columns[column + 1];
                    let mut entries = below.map(|at| (rows[at], self.values[at]));
                    see(column, self.values[columns[column]], &mut entries);
                }
            }
        }
    }

    /// Degree of freedom and scaled pivot, in the order of elimination.
    pub(crate) fn pivots(&self) -> Vec<(usize, f64)> {
        let order = self.symbolic.perm().map(|perm| perm.arrays().0);
        let mut pivots = Vec::with_capacity(self.scale.len());
        self.columns(|at, pivot, _| pivots.push((order.map_or(at, |order| order[at]), pivot)));
        pivots
    }

    /// One degree of freedom of each motion among the weakest that cannot be told from a loose one.
    fn loose_motions(&self) -> Vec<usize> {
        let (vectors, energies) = self.weakest();
        let mut loose: Vec<Vec<f64>> = Vec::new();
        for (at, energy) in energies.iter().enumerate() {
            let x: Vec<f64> = vectors.col(at).iter().copied().collect();
            if *energy <= MARGIN * f64::EPSILON * self.absolute_energy(&x) {
                loose.push(x);
            }
        }
        pivots_of(loose)
    }

    /// Whether the signs of the pivots are those of the matrix: rounding in the elimination changes the energy of the
    /// weakest motions by less than that energy.
    pub(crate) fn is_certain(&self) -> bool {
        let (vectors, energies) = self.weakest();
        energies.iter().enumerate().all(|(at, energy)| {
            let x: Vec<f64> = vectors.col(at).iter().copied().collect();
            energy.abs() > MARGIN * f64::EPSILON * self.factor_energy(&x)
        })
    }

    /// The weakest motions of the scaled matrix, orthonormal, and their energies (of either sign).
    fn weakest(&self) -> (Mat<f64>, Vec<f64>) {
        let n = self.scale.len();
        let mut x = Noise::new().extend(Mat::zeros(n, 0).as_ref(), WEAKEST.min(n));
        for _ in 0..ITERATIONS {
            orthonormalise(&mut x);
            x = self.solve_scaled(x);
        }
        orthonormalise(&mut x);
        let projected = inner(x.as_ref(), sparse::multiply(self.scaled.as_ref(), x.as_ref()).as_ref());
        let Ok(eigen) = projected.self_adjoint_eigen(Side::Lower) else {
            return (x, vec![0.0; WEAKEST.min(n)]);
        };
        (&x * eigen.U(), eigen.S().column_vector().iter().copied().collect())
    }

    /// |x|^T |A| |x|.
    fn absolute_energy(&self, x: &[f64]) -> f64 {
        let mut energy = 0.0;
        for (j, value) in x.iter().enumerate() {
            let column = self.scaled.row_idx_of_col(j).zip(self.scaled.val_of_col(j));
            energy += value.abs() * column.map(|(i, a)| x[i].abs() * a.abs()).sum::<f64>();
        }
        energy
    }

    /// |x|^T |L| |D| |L|^T |x|: what the elimination's rounding is measured by.
    fn factor_energy(&self, x: &[f64]) -> f64 {
        let order = self.symbolic.perm().map(|perm| perm.arrays().0);
        let size = |at: usize| x[order.map_or(at, |order| order[at])].abs();
        let mut energy = 0.0;
        self.columns(|at, pivot, below| {
            let sum = size(at) + below.map(|(row, value)| value.abs() * size(row)).sum::<f64>();
            energy += pivot.abs() * sum * sum;
        });
        energy
    }

    /// A^-1 b.
    pub(crate) fn solve(&self, b: MatRef<'_, f64>) -> Mat<f64> {
        let mut x = self.solve_scaled(Mat::from_fn(b.nrows(), b.ncols(), |i, j| self.scale[i] * b[(i, j)]));
        for j in 0..x.ncols() {
            for (i, scale) in self.scale.iter().enumerate() {
                x[(i, j)] *= scale;
            }
        }
        x
    }

    /// Columns are solved in groups of a fixed size, so the result is the same on any number of threads.
    fn solve_scaled(&self, mut x: Mat<f64>) -> Mat<f64> {
        let solve = |mut group: MatMut<'_, f64>| {
            let scratch = self.symbolic.solve_in_place_scratch::<f64>(group.ncols(), Par::Seq);
            let mut memory = MemBuffer::new(scratch);
            LdltRef::new(&self.symbolic, &self.values).solve_in_place_with_conj(
                Conj::No,
                group.as_mut(),
                Par::Seq,
                MemStack::new(&mut memory),
            );
        };
        x.par_col_chunks_mut(TOGETHER).for_each(solve);
        x
    }
}

/// The pattern of the factor in the order that fills in less.
pub(crate) fn analysed(pattern: SymbolicSparseColMatRef<'_, usize>) -> SymbolicCholesky<usize> {
    let analyse = |order: SymmetricOrdering<'_, usize>| {
        let params = CholeskySymbolicParams {
            supernodal_flop_ratio_threshold: SupernodalThreshold::FORCE_SUPERNODAL,
            ..Default::default()
        };
        factorize_symbolic_cholesky(pattern, Side::Lower, order, params)
            .expect("memory for the pattern of the factor")
    };
    let by_degree = analyse(SymmetricOrdering::Amd);
    let order = reverse_cuthill_mckee(pattern);
    let mut inverse = vec![0; order.len()];
    order.iter().enumerate().for_each(|(place, dof)| inverse[*dof] = place);
    let by_level = analyse(SymmetricOrdering::Custom(PermRef::new_checked(&order, &inverse, order.len())));
    tracing::debug!(by_degree = by_degree.len_val(), by_level = by_level.len_val(), "entries of the factor");
    if by_level.len_val() < by_degree.len_val() { by_level } else { by_degree }
}

/// One degree of freedom for each of those motions that cannot be told from a loose one.
fn loose_among(a: SparseColMatRef<'_, usize, f64>, motions: &Mat<f64>) -> Vec<usize> {
    let forces = sparse::multiply(a, motions.as_ref());
    let diagonal = sparse::diagonal(a);
    let mut loose = Vec::new();
    for j in 0..motions.ncols() {
        let x: Vec<f64> = motions.col(j).iter().copied().collect();
        let energy: f64 = x.iter().zip(forces.col(j).iter()).map(|(x, f)| x * f).sum();
        let mut size = 0.0;
        for (column, value) in x.iter().enumerate() {
            let entries = a.row_idx_of_col(column).zip(a.val_of_col(column));
            size += value.abs() * entries.map(|(i, a)| x[i].abs() * a.abs()).sum::<f64>();
        }
        if size > 0.0 && energy.abs() <= MARGIN * f64::EPSILON * size {
            loose.push(x.iter().zip(&diagonal).map(|(x, d)| x * d.max(0.0).sqrt()).collect());
        }
    }
    pivots_of(loose)
}

/// Gram-Schmidt, twice for each column; a column that vanishes stays zero.
fn orthonormalise(x: &mut Mat<f64>) {
    for j in 0..x.ncols() {
        for _ in 0..2 {
            for k in 0..j {
                let share: f64 = x.col(k).iter().zip(x.col(j).iter()).map(|(a, b)| a * b).sum();
                for i in 0..x.nrows() {
                    x[(i, j)] -= share * x[(i, k)];
                }
            }
            let norm = x.col(j).iter().map(|v| v * v).sum::<f64>().sqrt();
            if norm > 0.0 && norm.is_finite() {
                for i in 0..x.nrows() {
                    x[(i, j)] /= norm;
                }
            }
        }
    }
}

/// One place for each of some independent motions, so that holding these places holds them all: elimination with the
/// largest entry as pivot.
fn pivots_of(mut motions: Vec<Vec<f64>>) -> Vec<usize> {
    let mut places = Vec::new();
    while !motions.is_empty() {
        let peak = |x: &Vec<f64>| {
            x.iter()
                .enumerate()
                .max_by(|a, b| a.1.abs().total_cmp(&b.1.abs()))
                .map_or((0, 0.0), |(at, v)| (at, *v))
        };
        let largest = (0..motions.len())
            .max_by(|a, b| peak(&motions[*a]).1.abs().total_cmp(&peak(&motions[*b]).1.abs()));
        let pivot = motions.swap_remove(largest.unwrap_or(0));
        let (place, value) = peak(&pivot);
        if value == 0.0 {
            break;
        }
        places.push(place);
        for motion in &mut motions {
            let share = motion[place] / value;
            motion.iter_mut().zip(&pivot).for_each(|(x, p)| *x -= share * p);
        }
    }
    places
}

fn scaled(a: SparseColMatRef<'_, usize, f64>, scale: &[f64], springs: &[usize]) -> Sparse {
    let mut values = Vec::with_capacity(a.val().len());
    for j in 0..a.ncols() {
        for (i, value) in a.row_idx_of_col(j).zip(a.val_of_col(j)) {
            let spring = if i == j && springs.contains(&i) { 1.0 } else { 0.0 };
            values.push(scale[i] * value * scale[j] + spring);
        }
    }
    Sparse::new(a.symbolic().to_owned().expect("memory for a copy of the pattern"), values)
}

#[cfg(test)]
mod tests;
