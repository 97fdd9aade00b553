//! The lowest modes of a large structure by block Lanczos: the operator (K + s M)^-1 M on a growing M-orthonormal basis, begun
//! again from the best combinations when the basis is long (thick restarts: Wu and Simon, SIAM J. Matrix Anal. Appl. 22, 2000;
//! blocks and full orthogonalisation: Grimes, Lewis and Simon, SIAM J. Matrix Anal. Appl. 15, 1994).
//!
//! A direction costs one solve, where a sweep of subspace iteration costs one for every direction that it keeps. The operator's
//! small matrix has its eigenvalues to the round-off of the largest, the lowest mode's: this is not for all modes of a structure
//! whose frequencies range widely.

use crate::blocks::{Noise, inner, product};
use crate::subspace::{Inverse, New, Ritz, Space, beside};
use faer::sparse::SparseColMatRef;
use faer::{Mat, Side};

/// Directions that the operator is applied to together, as many as the factor solves together.
const BLOCK: usize = 8;

/// Blocks beyond twice the number of modes that a basis may have before the best of it are kept.
const ROOM: usize = 6;

/// Blocks in all.
const STEPS: usize = 1000;

/// A mode beyond those asked for is told of if it misses by no more than this.
const NEAR: f64 = 1e-3;

/// What was found.
#[derive(Debug)]
pub(crate) struct Found {
    /// Rigid motions, then elastic modes.
    pub(crate) ritz: Ritz,
    /// Whether no motion with mass is outside of the basis.
    pub(crate) is_complete: bool,
}

/// What is asked for.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Asked<'a> {
    /// The number of elastic modes.
    pub(crate) elastic: usize,
    /// How far each may miss, as [`crate::subspace::residuals`] has it; here that is estimated by the block that comes next.
    pub(crate) miss: f64,
    /// Elastic modes that are there already.
    pub(crate) known: &'a Ritz,
}

/// The lowest modes, and those after them that are nearly there; fewer if there are not so many. `None` if they cannot be had.
pub(crate) fn lowest(
    m: SparseColMatRef<'_, usize, f64>,
    inverse: &Inverse<'_>,
    noise: &mut Noise,
    asked: Asked<'_>,
) -> Option<Found> {
    let Asked { elastic, miss, known } = asked;
    let longest = (2 * elastic + ROOM * BLOCK).max(known.values.len() + 2 * BLOCK);
    let mut lanczos = Lanczos::new(m, inverse, known, longest);
    // Eigenpairs of a large small matrix take longer than some steps.
    let looks = (elastic / (ROOM * BLOCK)).max(1);
    for step in 0..STEPS {
        let is_complete = lanczos.next.columns.is_empty() && !lanczos.begins(noise)?;
        let coupling = lanczos.step()?;
        let is_full = lanczos.next.columns.end + BLOCK > inverse.rigid.count() + longest;
        let is_due = lanczos.small.ncols() >= elastic && step % looks == 0;
        if !(is_complete || is_full || is_due) {
            continue;
        }
        let pairs = lanczos.pairs(&coupling)?;
        let is_reached =
            pairs.misses.len() >= elastic && pairs.misses[..elastic].iter().all(|own| *own < miss);
        if is_complete || is_reached {
            tracing::debug!(steps = step + 1, is_complete, "block Lanczos");
            return Some(Found { ritz: lanczos.ritz(&pairs, elastic), is_complete });
        }
        if is_full {
            lanczos.restart(&pairs, elastic + BLOCK, longest);
        }
    }
    None
}

/// A basis after the rigid motions, and the operator on all of it but the last block.
struct Lanczos<'a> {
    inverse: &'a Inverse<'a>,
    space: Space<'a>,
    /// The operator between the directions that it was applied to.
    small: Mat<f64>,
    /// The block that it is applied to next.
    next: New,
}

/// Eigenpairs of the small matrix, the largest eigenvalue first, and how far each is from a mode.
struct Pairs {
    values: Vec<f64>,
    turn: Mat<f64>,
    misses: Vec<f64>,
}

impl<'a> Lanczos<'a> {
    fn new(
        m: SparseColMatRef<'a, usize, f64>,
        inverse: &'a Inverse<'a>,
        known: &Ritz,
        longest: usize,
    ) -> Self {
        let mut space = Space::new(m, inverse.rigid, inverse.rigid.count() + longest);
        let count = known.values.len();
        let small =
            Mat::from_fn(
                count,
                count,
                |i, j| if i == j { 1.0 / (known.values[j] + inverse.shift) } else { 0.0 },
            );
        if count > 0 {
            space.append(known.vectors.as_ref());
        }
        let end = space.basis.ncols();
        let next = New { columns: end..end, momenta: Mat::zeros(m.ncols(), 0) };
        Self { inverse, space, small, next }
    }

    fn first(&self) -> usize {
        self.inverse.rigid.count()
    }

    /// Begins with the motions of least stiffness, or anew beside what is there from noise; false if that has nothing new. The start
    /// itself may have parts without mass; what the factor makes of it has not.
    fn begins(&mut self, noise: &mut Noise) -> Option<bool> {
        let weak = self.inverse.factor.weak.as_ref();
        let start = if self.small.ncols() == 0 && weak.ncols() > 0 {
            weak.to_owned()
        } else {
            noise.extend(Mat::zeros(self.space.m.ncols(), 0).as_ref(), BLOCK)
        };
        self.next = self.space.extend(self.inverse.solve(self.space.momenta(start.as_ref())))?;
        Some(!self.next.columns.is_empty())
    }

    /// Applies the operator to the next block; what of that is new comes next, and how it hangs together with the block is returned.
    fn step(&mut self) -> Option<Mat<f64>> {
        let (first, start) = (self.first(), self.next.columns.start - self.first());
        let image = self.inverse.solve(std::mem::replace(&mut self.next.momenta, Mat::new()));
        let momenta = self.space.momenta(image.as_ref());
        let all = inner(self.space.basis.as_ref(), momenta.as_ref());
        let shares = all.subrows(first, all.nrows() - first);
        let small = &self.small;
        self.small = Mat::from_fn(shares.nrows(), shares.nrows(), |i, j| match (i < start, j < start) {
            (true, true) => small[(i, j)],
            (true, false) => shares[(i, j - start)],
            (false, true) => shares[(j, i - start)],
            (false, false) => 0.5 * (shares[(i, j - start)] + shares[(j, i - start)]),
        });
        self.next = self.space.extend_by(image.clone(), &momenta, &all)?;
        Some(inner(self.next.momenta.as_ref(), image.as_ref()))
    }

    /// The operator takes a pair out of the basis by the coupling times the pair's part in the block that came last.
    fn pairs(&self, coupling: &Mat<f64>) -> Option<Pairs> {
        let n = self.small.ncols();
        let eigen = self.small.self_adjoint_eigen(Side::Lower).ok()?;
        let turn = Mat::from_fn(n, n, |i, j| eigen.U()[(i, n - 1 - j)]);
        let values: Vec<f64> = eigen.S().column_vector().iter().rev().copied().collect();
        let block = coupling.ncols();
        let outside = product(coupling.as_ref(), turn.subrows(n - block, block));
        let miss = |j: usize| outside.col(j).iter().map(|x| x * x).sum::<f64>().sqrt() / values[j].abs();
        let misses = (0..n).map(miss).collect();
        Some(Pairs { values, turn, misses })
    }

    /// The first `count` pairs in place of the basis; what comes next stays.
    fn restart(&mut self, pairs: &Pairs, count: usize, longest: usize) {
        let (first, n) = (self.first(), self.small.ncols());
        let turn = pairs.turn.subcols(0, count);
        let kept = product(self.space.basis.subcols(first, n), turn);
        let columns = self.next.columns.clone();
        let basis = beside(kept.as_ref(), self.space.basis.subcols(columns.start, columns.len()));
        self.space.clear(self.inverse.rigid, first + longest);
        self.space.append(basis.as_ref());
        self.small = Mat::from_fn(count, count, |i, j| if i == j { pairs.values[i] } else { 0.0 });
        self.next.columns = first + count..first + basis.ncols();
    }

    /// At least `count` pairs, if there are as many, and those of the same block of solves that are nearly modes.
    fn ritz(&self, pairs: &Pairs, count: usize) -> Ritz {
        let first = self.first();
        let positive = pairs.values.iter().take_while(|value| **value > 0.0).count();
        let near = pairs.misses.iter().skip(count).take_while(|miss| **miss < NEAR).count();
        let kept = (count + near).min(count.next_multiple_of(BLOCK)).min(positive);
        let elastic = pairs.values[..kept].iter().map(|value| 1.0 / value - self.inverse.shift);
        let values = std::iter::repeat_n(0.0, first).chain(elastic).collect();
        let basis = self.space.basis.subcols(first, self.small.ncols());
        let shapes = product(basis, pairs.turn.subcols(0, kept));
        Ritz { values, vectors: beside(self.inverse.rigid.motions.as_ref(), shapes.as_ref()) }
    }
}

#[cfg(test)]
mod tests;
