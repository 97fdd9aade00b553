//! The sparse factorisation: S A S = L D L^T with S the scaling to a unit diagonal, without pivoting (faer, supernodal, with
//! a fill-reducing order).
//!
//! Whether a motion meets stiffness at all is asked of the weakest motions, found by inverse iteration with the factor:
//! rounding the entries of A alone changes the energy x^T A x of a motion by up to eps |x|^T |A| |x|. A motion whose energy is
//! not well above this cannot be told from a loose one. It is held by a spring where it moves most, so that the
//! elimination goes on and names every further one.
//!
//! This file is the seam to faer's sparse factorisation.

mod loose;
mod panels;

use self::loose::{absolute_energies, loose_among, pivots_of, sizes, stands_out};
use self::panels::{Panels, Row, TOGETHER};
use crate::blocks::{Noise, inner};
use crate::ordering::{self, levels::reverse_cuthill_mckee};
use crate::sparse;
use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::cholesky::ldlt::factor::LdltRegularization;
use faer::linalg::matmul::matmul;
use faer::perm::PermRef;
use faer::reborrow::{Reborrow as _, ReborrowMut as _};
use faer::sparse::linalg::SupernodalThreshold;
use faer::sparse::linalg::cholesky::{
    CholeskySymbolicParams, LdltRef, SymbolicCholesky, SymmetricOrdering, factorize_symbolic_cholesky,
};
use faer::sparse::{SparseColMatRef, SymbolicSparseColMatRef};
use faer::{Accum, Conj, Mat, MatMut, MatRef, Par, Side, Spec};
use rayon::prelude::*;
use std::sync::Arc;

/// Scaled pivots up to this one are held at once.
const LOOSE: f64 = 1e-14;

/// What a loose pivot is replaced by: greater than any scaled pivot of a positive definite matrix, which is at most one.
const HELD: f64 = 2.0;

/// How many of the weakest motions are looked at together: a free body has six.
const WEAKEST: usize = TOGETHER;

/// Inverse iterations on them. A motion that meets no stiffness stands out after the first.
const ITERATIONS: usize = 2;

/// Structures of more motions are ordered grid by grid, and their right-hand sides go through the factor side by side. In smaller
/// ones there is little to be won, and all modes of a slender wing, which range over twelve decimals, hang on the rounding.
pub(crate) const SMALL: usize = 1000;

/// The pattern of a factor in its order of elimination; the same for every matrix of one pattern.
pub(crate) type Analysis = SymbolicCholesky<usize>;

/// S A S = L D L^T with S the scaling to a unit diagonal.
#[derive(Debug)]
pub(crate) struct Factor {
    symbolic: Arc<Analysis>,
    values: Vec<f64>,
    scale: Vec<f64>,
    /// Degrees of freedom at which loose motions were held ([`Factor::held`] only).
    pub(crate) loose: Vec<usize>,
    /// Motions that meet little stiffness, whether loose or not, from which to search for modes ([`Factor::held`] only).
    pub(crate) weak: Mat<f64>,
    /// Whether the signs of the pivots are those of the matrix ([`Factor::indefinite`] only).
    pub(crate) is_certain: bool,
}

/// The memory of a factor that is done with, for another one: to ask the system for as much again takes as long as to fill it.
#[derive(Debug, Default)]
pub(crate) struct Room(Vec<f64>);

/// The matrix that is factorised: S A S, with springs.
pub(crate) struct Scaled<'a> {
    pattern: SymbolicSparseColMatRef<'a, usize>,
    values: Vec<f64>,
    scale: Vec<f64>,
}

impl<'a> Scaled<'a> {
    /// Of a matrix by its pattern and values, scaled to the size of each degree of freedom.
    pub(crate) fn of(
        pattern: SymbolicSparseColMatRef<'a, usize>,
        mut values: Vec<f64>,
        size: &[f64],
    ) -> Self {
        let scale: Vec<f64> = size.iter().map(|d| if *d > 0.0 { 1.0 / d.sqrt() } else { 1.0 }).collect();
        for j in 0..pattern.ncols() {
            for (i, value) in pattern.row_idx_of_col(j).zip(&mut values[pattern.col_range(j)]) {
                *value = scale[i] * *value * scale[j];
            }
        }
        Self { pattern, values, scale }
    }

    /// With springs of one on the diagonal.
    fn held(mut self, springs: &[usize]) -> Self {
        for dof in springs {
            let rows = self.pattern.row_idx_of_col_raw(*dof);
            let place = rows.binary_search(dof).expect("every diagonal entry is there");
            self.values[self.pattern.col_range(*dof).start + place] += 1.0;
        }
        self
    }

    fn matrix(&self) -> SparseColMatRef<'_, usize, f64> {
        SparseColMatRef::new(self.pattern, &self.values)
    }
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
            let (mut factor, scaled) = Self::with_springs(analysis, a, &springs);
            let found =
                if factor.loose.is_empty() { factor.loose_motions(&scaled) } else { factor.loose.clone() };
            let new: Vec<usize> = found.into_iter().filter(|dof| !springs.contains(dof)).collect();
            if new.is_empty() {
                factor.loose = springs;
                return factor;
            }
            springs.extend(new);
        }
    }

    /// With springs to the ground at some degrees of freedom, as stiff as what they hold.
    fn with_springs<'a>(
        analysis: &Arc<Analysis>,
        a: SparseColMatRef<'a, usize, f64>,
        springs: &[usize],
    ) -> (Self, Scaled<'a>) {
        let regularization = LdltRegularization {
            dynamic_regularization_signs: Some(&vec![1; a.ncols()]),
            dynamic_regularization_delta: HELD,
            dynamic_regularization_epsilon: LOOSE,
        };
        let scaled = Scaled::of(a.symbolic(), a.val().to_vec(), &sparse::diagonal(a)).held(springs);
        let mut factor = Self::new(analysis, &scaled, regularization, Room::default())
            .expect("a positive pivot is put in the place of every other, and entries are finite");
        let loose = factor.pivots().into_iter().filter(|(_, pivot)| *pivot == HELD).map(|(dof, _)| dof);
        factor.loose = loose.collect();
        (factor, scaled)
    }

    /// Of an indefinite matrix, without pivoting; `None` if a pivot is exactly zero.
    pub(crate) fn indefinite(analysis: &Arc<Analysis>, scaled: &Scaled<'_>, room: Room) -> Option<Self> {
        let mut factor = Self::new(analysis, scaled, LdltRegularization::default(), room)?;
        factor.is_certain = factor.has_certain_signs(scaled);
        Some(factor)
    }

    fn new(
        analysis: &Arc<Analysis>,
        scaled: &Scaled<'_>,
        regularization: LdltRegularization<'_, f64>,
        Room(mut values): Room,
    ) -> Option<Self> {
        let symbolic = Arc::clone(analysis);
        values.resize(symbolic.len_val(), 0.0);
        // On one thread: faer's tasks for each panel took a sixth more clock time on two cores for 12,000 shells.
        let par = Par::Seq;
        let mut memory = MemBuffer::new(symbolic.factorize_numeric_ldlt_scratch::<f64>(par, Spec::default()));
        symbolic
            .factorize_numeric_ldlt(
                &mut values,
                scaled.matrix(),
                Side::Lower,
                regularization,
                par,
                MemStack::new(&mut memory),
                Spec::default(),
            )
            .ok()?;
        let scale = scaled.scale.clone();
        Some(Self { symbolic, values, scale, loose: Vec::new(), weak: Mat::new(), is_certain: false })
    }

    /// What it leaves behind.
    pub(crate) fn into_room(self) -> Room {
        Room(self.values)
    }

    /// Calls `see` for each column of L in the order of elimination: its number, pivot, and the entries below it (row in
    /// the order of elimination, value).
    fn columns(&self, mut see: impl FnMut(usize, f64, &mut dyn Iterator<Item = (usize, f64)>)) {
        let panels = Panels::of(&self.symbolic, &self.values);
        for panel in (0..panels.count()).map(|at| panels.panel(at)) {
            for at in 0..panel.width {
                let [pivot, below @ ..] = panel.column(at) else { continue };
                let inside = panel.start + at + 1..panel.start + panel.width;
                let rows = inside.chain(panel.rows.iter().copied());
                see(panel.start + at, *pivot, &mut rows.zip(below.iter().copied()));
            }
        }
    }

    /// Degree of freedom and scaled pivot, in the order of elimination.
    pub(crate) fn pivots(&self) -> Vec<(usize, f64)> {
        let mut pivots = Vec::with_capacity(self.scale.len());
        self.columns(|at, pivot, _| pivots.push((self.dof_at(at), pivot)));
        pivots
    }

    /// One degree of freedom of each motion among the weakest that cannot be told from a loose one.
    fn loose_motions(&mut self, scaled: &Scaled<'_>) -> Vec<usize> {
        let (vectors, energies) = self.weakest(scaled);
        self.weak = Mat::from_fn(vectors.nrows(), vectors.ncols(), |i, j| self.scale[i] * vectors[(i, j)]);
        let mut loose: Vec<Vec<f64>> = Vec::new();
        let sizes = absolute_energies(scaled.matrix(), vectors.as_ref());
        for (at, (energy, size)) in energies.iter().zip(sizes).enumerate() {
            if *energy <= 0.0 || !stands_out(*energy, size) {
                loose.push(vectors.col(at).iter().copied().collect());
            }
        }
        pivots_of(loose)
    }

    /// Whether the signs of the pivots are those of the matrix: rounding in the elimination changes the energy of the
    /// weakest motions by less than that energy.
    fn has_certain_signs(&self, scaled: &Scaled<'_>) -> bool {
        let (vectors, energies) = self.weakest(scaled);
        let rounded = self.factor_energies(vectors.as_ref());
        energies.iter().zip(rounded).all(|(energy, rounded)| stands_out(*energy, rounded))
    }

    /// The weakest motions of the scaled matrix, orthonormal, and their energies (of either sign).
    fn weakest(&self, scaled: &Scaled<'_>) -> (Mat<f64>, Vec<f64>) {
        let n = self.scale.len();
        let mut x = Noise::new().extend(Mat::zeros(n, 0).as_ref(), WEAKEST.min(n));
        for _ in 0..ITERATIONS {
            orthonormalise(&mut x);
            x = self.solve_scaled(x.as_ref(), |_| 1.0);
        }
        orthonormalise(&mut x);
        let projected = inner(x.as_ref(), sparse::multiply(scaled.matrix(), x.as_ref()).as_ref());
        let Ok(eigen) = projected.self_adjoint_eigen(Side::Lower) else {
            return (x, vec![0.0; WEAKEST.min(n)]);
        };
        (&x * eigen.U(), eigen.S().column_vector().iter().copied().collect())
    }

    /// |x|^T |L| |D| |L|^T |x| of each column, at most [`TOGETHER`]: what the elimination's rounding is measured by.
    fn factor_energies(&self, x: MatRef<'_, f64>) -> Row {
        let sizes = sizes(x, (0..x.nrows()).map(|place| self.dof_at(place)));
        let mut energies = [0.0; TOGETHER];
        self.columns(|at, pivot, below| {
            let mut sums = sizes[at];
            for (place, value) in below {
                sums.iter_mut().zip(&sizes[place]).for_each(|(sum, x)| *sum += value.abs() * x);
            }
            energies.iter_mut().zip(&sums).for_each(|(energy, sum)| *energy += pivot.abs() * sum * sum);
        });
        energies
    }

    /// A^-1 b.
    pub(crate) fn solve(&self, b: MatRef<'_, f64>) -> Mat<f64> {
        self.solve_scaled(b, |dof| self.scale[dof])
    }

    /// S (L D L^T)^-1 S b for a scale S of each degree of freedom. Columns go in groups of a fixed size: the result is the same on any
    /// number of threads.
    fn solve_scaled(&self, b: MatRef<'_, f64>, scale: impl Fn(usize) -> f64 + Sync) -> Mat<f64> {
        if b.nrows() <= SMALL {
            let mut x = Mat::from_fn(b.nrows(), b.ncols(), |i, j| scale(i) * b[(i, j)]);
            x.par_col_chunks_mut(TOGETHER).for_each(|group| self.solve_few(group));
            return Mat::from_fn(b.nrows(), b.ncols(), |i, j| scale(i) * x[(i, j)]);
        }
        let mut x = Mat::zeros(b.nrows(), b.ncols());
        self.solve_side_by_side(b, x.as_mut(), scale);
        x
    }

    fn solve_few(&self, x: MatMut<'_, f64>) {
        let mut memory = MemBuffer::new(self.symbolic.solve_in_place_scratch::<f64>(x.ncols(), Par::Seq));
        let factor = LdltRef::new(&self.symbolic, &self.values);
        factor.solve_in_place_with_conj(Conj::No, x, Par::Seq, MemStack::new(&mut memory));
    }

    fn solve_side_by_side(
        &self,
        b: MatRef<'_, f64>,
        x: MatMut<'_, f64>,
        scale: impl Fn(usize) -> f64 + Sync,
    ) {
        let panels = Panels::of(&self.symbolic, &self.values);
        let one_group = |(mut x, b): (MatMut<'_, f64>, MatRef<'_, f64>)| {
            let mut rows: Vec<Row> = vec![[0.0; TOGETHER]; x.nrows()];
            for (place, row) in rows.iter_mut().enumerate() {
                let dof = self.dof_at(place);
                let scale = scale(dof);
                row.iter_mut().zip(b.row(dof).iter()).for_each(|(own, b)| *own = scale * b);
            }
            panels.solve(&mut rows);
            for (place, row) in rows.iter().enumerate() {
                let dof = self.dof_at(place);
                let scale = scale(dof);
                x.rb_mut().row_mut(dof).iter_mut().zip(row).for_each(|(x, own)| *x = scale * own);
            }
        };
        if b.ncols() <= TOGETHER {
            return one_group((x, b));
        }
        x.par_col_chunks_mut(TOGETHER).zip(b.par_col_chunks(TOGETHER)).for_each(one_group);
    }

    /// The degree of freedom at a place in the order of elimination.
    fn dof_at(&self, place: usize) -> usize {
        self.symbolic.perm().map_or(place, |perm| perm.arrays().0[place])
    }
}

/// The pattern of the factor in the order that fills in least.
pub(crate) fn analysed(pattern: SymbolicSparseColMatRef<'_, usize>) -> SymbolicCholesky<usize> {
    let analyse = |order: SymmetricOrdering<'_, usize>| {
        let params = CholeskySymbolicParams {
            supernodal_flop_ratio_threshold: SupernodalThreshold::FORCE_SUPERNODAL,
            ..Default::default()
        };
        factorize_symbolic_cholesky(pattern, Side::Lower, order, params)
            .expect("memory for the pattern of the factor")
    };
    let by = |order: &[usize]| {
        let inverse = ordering::inverse(order);
        analyse(SymmetricOrdering::Custom(PermRef::new_checked(order, &inverse, order.len())))
    };
    if pattern.ncols() > SMALL {
        return by(&ordering::of_least_fill(pattern));
    }
    let (by_degree, by_level) = (analyse(SymmetricOrdering::Amd), by(&reverse_cuthill_mckee(pattern)));
    if by_level.len_val() < by_degree.len_val() { by_level } else { by_degree }
}

/// Gram-Schmidt, twice for each column; a column that vanishes stays zero.
fn orthonormalise(x: &mut Mat<f64>) {
    for j in 0..x.ncols() {
        let (done, mut own) = x.as_mut().split_at_col_mut(j);
        let (done, mut own) = (done.rb(), own.rb_mut().subcols_mut(0, 1));
        for _ in 0..2 {
            let shares = inner(done, own.rb());
            matmul(own.rb_mut(), Accum::Add, done, shares.as_ref(), -1.0, Par::Seq);
        }
        let norm = own.rb().col(0).norm_l2();
        if norm > 0.0 && norm.is_finite() {
            own.col_mut(0).iter_mut().for_each(|x| *x /= norm);
        }
    }
}

#[cfg(test)]
mod tests;
