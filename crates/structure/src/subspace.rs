//! A block Krylov space, M-orthonormal, and its Rayleigh-Ritz values: one sweep of subspace iteration.

use crate::blocks::{add_product, inner, product};
use crate::factor::Factor;
use crate::sparse;
use faer::sparse::SparseColMatRef;
use faer::{Mat, MatRef, Side};

/// A direction that keeps less than this share of the square of its length is in the space of those before it.
const DEPENDENT: f64 = 1e-24;

/// Columns of one block whose combination keeps less than this share (of squares of unit columns) are alike.
const ALIKE: f64 = 1e-13;

/// Rounds of right angles in which a block comes to rest, at most.
const ROUNDS: usize = 5;

/// A block whose inner products are those of unit vectors at right angles within this has come to rest: the turn that is left does
/// not bring the basis back in.
const SAME: f64 = 1e-3;

type SparseRef<'a> = SparseColMatRef<'a, usize, f64>;

/// Ritz pairs: values ascending, vectors M-orthonormal.
#[derive(Debug)]
pub(crate) struct Ritz {
    pub(crate) values: Vec<f64>,
    pub(crate) vectors: Mat<f64>,
}

impl Ritz {
    /// All after the first ones.
    pub(crate) fn after(&self, first: usize) -> Self {
        let first = first.min(self.values.len());
        let vectors = self.vectors.subcols(first, self.values.len() - first).to_owned();
        Self { values: self.values[first..].to_vec(), vectors }
    }
}

/// (K + s M)^-1 on momenta. Without a shift a free-free structure is held by springs where its rigid motions move: momenta without
/// a resultant leave the springs without force, so that the answer is exact up to a rigid motion, which is taken out.
pub(crate) struct Inverse<'a> {
    pub(crate) factor: &'a Factor,
    pub(crate) shift: f64,
    pub(crate) rigid: &'a Rigid,
}

/// Rigid motions, M-orthonormal, and their momenta; no columns if the factor holds none or a shift does.
#[derive(Debug)]
pub(crate) struct Rigid {
    pub(crate) motions: Mat<f64>,
    pub(crate) momenta: Mat<f64>,
}

impl Rigid {
    /// No rigid motions.
    pub(crate) fn none(n: usize) -> Self {
        Self { motions: Mat::zeros(n, 0), momenta: Mat::zeros(n, 0) }
    }

    /// The motions that a held factor's springs were put against; `None` if some of them have no mass.
    pub(crate) fn of(m: SparseRef<'_>, factor: &Factor) -> Option<Self> {
        let mut forces = Mat::zeros(m.ncols(), factor.loose.len());
        factor.loose.iter().enumerate().for_each(|(j, dof)| forces[(*dof, j)] = 1.0);
        let mut space = Space::new(m, &Self::none(m.ncols()), factor.loose.len());
        let found = space.extend(factor.solve(forces.as_ref()))?;
        (found.columns.len() == factor.loose.len())
            .then_some(Self { motions: space.basis, momenta: found.momenta })
    }

    /// Number of rigid motions.
    pub(crate) fn count(&self) -> usize {
        self.motions.ncols()
    }
}

impl Inverse<'_> {
    pub(crate) fn solve(&self, momenta: Mat<f64>) -> Mat<f64> {
        if self.rigid.count() == 0 {
            return self.factor.solve(momenta.as_ref());
        }
        let Rigid { motions, momenta: of_rigid } = self.rigid;
        let mut balanced = momenta;
        let resultant = inner(motions.as_ref(), balanced.as_ref());
        add_product(&mut balanced, -1.0, of_rigid.as_ref(), resultant.as_ref());
        let mut x = self.factor.solve(balanced.as_ref());
        let share = inner(of_rigid.as_ref(), x.as_ref());
        add_product(&mut x, -1.0, motions.as_ref(), share.as_ref());
        x
    }
}

/// How often (K + s M)^-1 M is applied to a block before the Rayleigh-Ritz values are taken: the space is then a
/// block Krylov space, in which the lowest modes converge several times as fast as by applying it once.
const DEPTH: usize = 2;

/// Rayleigh-Ritz pairs of the space spanned by the rigid motions, x (its columns after as many as those), (K + s M)^-1 M x and
/// so on; `None` if the small problem does not converge.
pub(crate) fn sweep(
    k: SparseRef<'_>,
    m: SparseRef<'_>,
    inverse: &Inverse<'_>,
    x: MatRef<'_, f64>,
) -> Option<Ritz> {
    let first = inverse.rigid.count();
    let x = x.subcols(first, x.ncols() - first);
    let mut space = Space::new(m, inverse.rigid, first + (1 + DEPTH) * x.ncols());
    // The start itself may have parts without mass; what the factor makes of it has not.
    let mut last = space.extend(inverse.solve(sparse::multiply(m, x)))?;
    for _ in 0..DEPTH {
        last = space.extend(inverse.solve(last.momenta))?;
    }
    let basis = space.basis;
    let projected = inner(basis.as_ref(), sparse::multiply(k, basis.as_ref()).as_ref());
    let eigen = projected.self_adjoint_eigen(Side::Lower).ok()?;
    let values = eigen.S().column_vector().iter().copied().collect();
    Some(Ritz { values, vectors: product(basis.as_ref(), eigen.U()) })
}

/// One more step with a converged block, its values from the projected (K + s M) Y = M X as Bathe takes them: K itself, whose
/// entries are many orders of magnitude above the lowest modes' energy, does not enter. Rigid motions stay as they are. Beside it
/// how far each elastic pair of the block was from a mode, as [`residuals`] has it but for eight digits of one.
pub(crate) fn refined(
    m: SparseRef<'_>,
    inverse: &Inverse<'_>,
    ritz: &Ritz,
    count: usize,
) -> Option<(Ritz, Vec<f64>)> {
    let n = ritz.vectors.nrows();
    let (first, shift) = (inverse.rigid.count(), inverse.shift);
    let count = count.checked_sub(first).filter(|count| *count > 0)?;
    let scaled =
        Mat::from_fn(n, count, |i, j| (ritz.values[first + j] + shift) * ritz.vectors[(i, first + j)]);
    let momenta = sparse::multiply(m, scaled.as_ref());
    let y = inverse.solve(momenta.clone());
    let symmetric = |a: Mat<f64>| Mat::from_fn(count, count, |i, j| 0.5 * (a[(i, j)] + a[(j, i)]));
    let stiffness = symmetric(inner(y.as_ref(), momenta.as_ref()));
    let mass = symmetric(inner(y.as_ref(), sparse::multiply(m, y.as_ref()).as_ref()));
    // M = V D V^T; with W = V D^-1/2 the problem is W^T K W.
    let eigen = mass.self_adjoint_eigen(Side::Lower).ok()?;
    let (v, d) = (eigen.U(), eigen.S().column_vector());
    if d.iter().any(|value| *value <= ALIKE) {
        return None;
    }
    let w = Mat::from_fn(count, count, |i, j| v[(i, j)] / d[j].sqrt());
    let small = symmetric(w.transpose() * &stiffness * &w);
    let eigen = small.self_adjoint_eigen(Side::Lower).ok()?;
    let elastic = eigen.S().column_vector().iter().map(|value| value - shift).collect::<Vec<f64>>();
    let values = [&ritz.values[..first], &elastic].concat();
    let shapes = product(y.as_ref(), product(w.as_ref(), eigen.U()).as_ref());
    // |y - x|^2 with M x as above and |x| = 1.
    let square = |j: usize| mass[(j, j)] - 2.0 * stiffness[(j, j)] / (ritz.values[first + j] + shift) + 1.0;
    let misses = (0..count).map(|j| square(j).max(0.0).sqrt()).collect();
    let refined = Ritz { values, vectors: beside(inverse.rigid.motions.as_ref(), shapes.as_ref()) };
    Some((refined, misses))
}

/// An M-orthonormal basis.
pub(crate) struct Space<'a> {
    pub(crate) m: SparseRef<'a>,
    pub(crate) basis: Mat<f64>,
}

/// What a block has brought: where in the basis it stands, and its momenta M x.
pub(crate) struct New {
    pub(crate) columns: std::ops::Range<usize>,
    pub(crate) momenta: Mat<f64>,
}

impl<'a> Space<'a> {
    /// The rigid motions, with room for `columns` directions in all.
    pub(crate) fn new(m: SparseRef<'a>, rigid: &Rigid, columns: usize) -> Self {
        let mut space = Self { m, basis: Mat::new() };
        space.clear(rigid, columns);
        space
    }

    /// The rigid motions alone again.
    pub(crate) fn clear(&mut self, rigid: &Rigid, columns: usize) {
        self.basis.reserve(self.m.ncols(), columns);
        self.basis.resize_with(self.m.ncols(), 0, |_, _| 0.0);
        self.append(rigid.motions.as_ref());
    }

    /// Adds directions that are M-orthonormal with all before them.
    pub(crate) fn append(&mut self, x: MatRef<'_, f64>) {
        let start = self.basis.ncols();
        self.basis.resize_with(x.nrows(), start + x.ncols(), |i, j| x[(i, j - start)]);
    }

    /// M x.
    pub(crate) fn momenta(&self, x: MatRef<'_, f64>) -> Mat<f64> {
        sparse::multiply(self.m, x)
    }

    /// As [`Space::extend_by`] of a block of which nothing is known.
    pub(crate) fn extend(&mut self, x: Mat<f64>) -> Option<New> {
        let momenta = self.momenta(x.as_ref());
        let shares = inner(self.basis.as_ref(), momenta.as_ref());
        self.extend_by(x, &momenta, &shares)
    }

    /// Adds the directions of `x` that are new; given are its momenta and what these share with the basis. What lies in the basis is
    /// taken out, and the block is turned to the eigenvectors of its own inner products (SVQB), dependent and massless directions left
    /// out; again until a round has left the block as it was, which is twice as a rule.
    pub(crate) fn extend_by(
        &mut self,
        mut x: Mat<f64>,
        momenta: &Mat<f64>,
        shares: &Mat<f64>,
    ) -> Option<New> {
        let start = self.basis.ncols();
        let before = squares(x.as_ref(), momenta.as_ref());
        let mut momenta = self.project(&mut x, shares);
        // What is left of each column in units of its own length: a small new direction counts as much as a large one.
        let after = squares(x.as_ref(), momenta.as_ref());
        let new: Vec<usize> = (0..x.ncols()).filter(|j| after[*j] > DEPENDENT * before[*j]).collect();
        let unit =
            |y: &Mat<f64>| Mat::from_fn(y.nrows(), new.len(), |i, j| y[(i, new[j])] / after[new[j]].sqrt());
        (x, momenta) = (unit(&x), unit(&momenta));
        for round in 0..ROUNDS {
            let gram = inner(x.as_ref(), momenta.as_ref());
            let gram = Mat::from_fn(gram.nrows(), gram.ncols(), |i, j| 0.5 * (gram[(i, j)] + gram[(j, i)]));
            let eigen = gram.self_adjoint_eigen(Side::Lower).ok()?;
            let values: Vec<f64> = eigen.S().column_vector().iter().copied().collect();
            // What is left after the first round is orthonormal but for round-off.
            let least = if round == 0 { ALIKE } else { 0.25 };
            let kept: Vec<usize> = (0..values.len()).filter(|at| values[*at] > least).collect();
            let u = eigen.U();
            let turn = Mat::from_fn(u.nrows(), kept.len(), |i, j| u[(i, kept[j])] / values[kept[j]].sqrt());
            x = product(x.as_ref(), turn.as_ref());
            if round > 0 && values.iter().all(|value| (value - 1.0).abs() < SAME) {
                momenta = product(momenta.as_ref(), turn.as_ref());
                break;
            }
            // Afresh: what came out of small differences has lost its right angle with the basis, and its momentum.
            let shares = inner(self.basis.as_ref(), self.momenta(x.as_ref()).as_ref());
            momenta = self.project(&mut x, &shares);
        }
        self.append(x.as_ref());
        Some(New { columns: start..self.basis.ncols(), momenta })
    }

    /// Takes its shares of the basis out of `x`, and returns the momenta of what is left.
    fn project(&self, x: &mut Mat<f64>, shares: &Mat<f64>) -> Mat<f64> {
        add_product(x, -1.0, self.basis.as_ref(), shares.as_ref());
        self.momenta(x.as_ref())
    }
}

/// Inner products of the columns of `x` with those of `y`, one by one.
fn squares(x: MatRef<'_, f64>, y: MatRef<'_, f64>) -> Vec<f64> {
    (0..x.ncols()).map(|j| x.col(j).iter().zip(y.col(j).iter()).map(|(a, b)| a * b).sum()).collect()
}

/// Columns of `x`, then those of `y`.
pub(crate) fn beside(x: MatRef<'_, f64>, y: MatRef<'_, f64>) -> Mat<f64> {
    let (n, first) = (y.nrows(), x.ncols());
    Mat::from_fn(n, first + y.ncols(), |i, j| if j < first { x[(i, j)] } else { y[(i, j - first)] })
}

/// How far each of the first `count` pairs is from being a mode, rigid motions left out: the M-norm of
/// (lambda + s) (K + s M)^-1 M x - x. Unlike K x - lambda M x this is not drowned by the round-off of the stiffest motions.
pub(crate) fn residuals(m: SparseRef<'_>, inverse: &Inverse<'_>, ritz: &Ritz, count: usize) -> Vec<f64> {
    let first = inverse.rigid.count().min(count);
    let x = ritz.vectors.subcols(first, count - first);
    let image = inverse.solve(sparse::multiply(m, x));
    let factors = &ritz.values[first..];
    let shift = inverse.shift;
    let error = Mat::from_fn(x.nrows(), x.ncols(), |i, j| (factors[j] + shift) * image[(i, j)] - x[(i, j)]);
    let squares = squares(error.as_ref(), sparse::multiply(m, error.as_ref()).as_ref());
    squares.into_iter().map(|square| square.max(0.0).sqrt()).collect()
}

#[cfg(test)]
mod tests;
