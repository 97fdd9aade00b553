//! All modes of a small structure, each to about the same relative error, however far frequencies range.
//!
//! Iterations on (K + s M)^-1 M have the round-off of the lowest mode in all of them, those on K that of the highest: a slender
//! wing's squares of frequencies span twelve decades and more, and neither has them all. One-sided Jacobi rotations of a Cholesky
//! factor do: their errors grow with the condition of the stiffness scaled to a unit diagonal, not with its own (Demmel and
//! Veselic, *Jacobi's method is more accurate than QR*, SIAM J. Matrix Anal. Appl. 13, 1992).
//!
//! M = G G' by pivots, as far as there are any, splits motions into those with mass, z = G' x, and those without, which follow
//! statically: in K they come first, and the rest of its factor is that of the stiffness condensed to z.

use crate::subspace::Ritz;
use faer::linalg::triangular_solve::solve_upper_triangular_in_place;
use faer::sparse::SparseColMatRef;
use faer::{Mat, MatRef, Par};

/// Pivots of the mass, over its diagonal, below which what is left is round-off.
const MASSLESS: f64 = 1e-10;

/// Sweeps of rotations at most: they converge quadratically, in far fewer.
const SWEEPS: usize = 60;

/// Numbers that are summed side by side.
const LANES: usize = 8;

/// All modes of a structure that is held, by rising frequency; none if the stiffness is not positive.
pub(crate) fn all_modes(
    k: SparseColMatRef<'_, usize, f64>,
    m: SparseColMatRef<'_, usize, f64>,
) -> Option<Ritz> {
    let n = k.ncols();
    let (k, m) = (k.to_dense(), m.to_dense());
    let unit = |i: usize| {
        let size = if m[(i, i)] > 0.0 { m[(i, i)] } else { k[(i, i)] };
        (size > 0.0).then(|| size.sqrt().recip())
    };
    let scale: Vec<f64> = (0..n).map(unit).collect::<Option<_>>()?;
    let scaled = |a: &Mat<f64>| Mat::from_fn(n, n, |i, j| scale[i] * a[(i, j)] * scale[j]);
    let mass = Pivoted::of(scaled(&m), n, MASSLESS);
    let (rank, massless) = (mass.rank, n - mass.rank);
    let motions = motions(&mass);
    let stiffness = motions.transpose() * scaled(&k) * &motions;
    let stiffness = Pivoted::of(stiffness, massless, n as f64 * f64::EPSILON);
    if stiffness.rank < n {
        return None;
    }
    let l = stiffness.l.as_ref();
    let (followed, own) =
        (l.submatrix(massless, 0, rank, massless), l.submatrix(massless, massless, rank, rank));
    let (values, shapes) = left_singular(own)?;
    let mut follow = -(followed.transpose() * &shapes);
    solve_upper_triangular_in_place(
        l.submatrix(0, 0, massless, massless).transpose(),
        follow.as_mut(),
        Par::Seq,
    );
    let mut coordinates = Mat::zeros(n, rank);
    for (at, place) in stiffness.order.iter().enumerate() {
        for j in 0..rank {
            coordinates[(*place, j)] =
                if at < massless { follow[(at, j)] } else { shapes[(at - massless, j)] };
        }
    }
    let mut vectors = motions * coordinates;
    for j in 0..rank {
        for i in 0..n {
            vectors[(i, j)] *= scale[i];
        }
    }
    Some(Ritz { values: values.iter().map(|value| value * value).collect(), vectors })
}

/// Scaled motions as columns: first those that no mass follows, then those of which each has one.
fn motions(mass: &Pivoted) -> Mat<f64> {
    let (n, rank) = (mass.order.len(), mass.rank);
    let massless = n - rank;
    let l = mass.l.as_ref();
    let mut held = Mat::zeros(rank, n);
    for j in 0..massless {
        for i in 0..rank {
            held[(i, j)] = -l[(rank + j, i)];
        }
    }
    for i in 0..rank {
        held[(i, massless + i)] = 1.0;
    }
    solve_upper_triangular_in_place(l.submatrix(0, 0, rank, rank).transpose(), held.as_mut(), Par::Seq);
    let mut motions = Mat::zeros(n, n);
    for (at, place) in mass.order.iter().enumerate() {
        for j in 0..n {
            motions[(*place, j)] =
                if at < rank { held[(at, j)] } else { f64::from(u8::from(at - rank == j)) };
        }
    }
    motions
}

/// A matrix with some of its rows and columns exchanged, as the product of a lower triangle with its transpose.
struct Pivoted {
    l: Mat<f64>,
    /// Which row of the matrix comes where.
    order: Vec<usize>,
    /// Number of pivots.
    rank: usize,
}

impl Pivoted {
    /// The largest pivots first, but all of the first `before` rows before the others; it ends where the largest is below
    /// this share of what was there on its place.
    fn of(mut a: Mat<f64>, before: usize, least: f64) -> Self {
        let n = a.nrows();
        let whole: Vec<f64> = (0..n).map(|i| a[(i, i)]).collect();
        let mut order: Vec<usize> = (0..n).collect();
        let mut l = Mat::zeros(n, n);
        for j in 0..n {
            let end = if j < before { before } else { n };
            let largest = (j..end).reduce(|p, q| if a[(q, q)] > a[(p, p)] { q } else { p });
            let Some(pivot) = largest.filter(|p| a[(*p, *p)] > least * whole[order[*p]]) else {
                return Self { l, order, rank: j };
            };
            order.swap(j, pivot);
            exchange(&mut a, j, pivot);
            for i in 0..j {
                (l[(j, i)], l[(pivot, i)]) = (l[(pivot, i)], l[(j, i)]);
            }
            let root = a[(j, j)].sqrt();
            l[(j, j)] = root;
            for i in j + 1..n {
                l[(i, j)] = a[(i, j)] / root;
            }
            for c in j + 1..n {
                let factor = l[(c, j)];
                for i in j + 1..n {
                    a[(i, c)] -= factor * l[(i, j)];
                }
            }
        }
        Self { l, order, rank: n }
    }
}

/// Exchanges two rows and columns.
fn exchange(a: &mut Mat<f64>, one: usize, other: usize) {
    for i in 0..a.nrows() {
        (a[(i, one)], a[(i, other)]) = (a[(i, other)], a[(i, one)]);
    }
    for i in 0..a.nrows() {
        (a[(one, i)], a[(other, i)]) = (a[(other, i)], a[(one, i)]);
    }
}

/// Singular values by rising size, and left singular vectors; none if rotations do not end.
fn left_singular(a: MatRef<'_, f64>) -> Option<(Vec<f64>, Mat<f64>)> {
    let n = a.nrows();
    let mut columns: Vec<Vec<f64>> = (0..n).map(|j| a.col(j).iter().copied().collect()).collect();
    let right = n as f64 * f64::EPSILON;
    for _ in 0..SWEEPS {
        let mut is_done = true;
        for p in 0..n {
            let (before, after) = columns.split_at_mut(p + 1);
            let first = &mut before[p];
            for second in after {
                is_done &= !rotates(first, second, right);
            }
        }
        if is_done {
            let size = |column: &Vec<f64>| dot(column, column).sqrt();
            let mut sorted: Vec<(f64, &Vec<f64>)> = columns.iter().map(|own| (size(own), own)).collect();
            sorted.sort_by(|a, b| a.0.total_cmp(&b.0));
            let vectors = Mat::from_fn(n, n, |i, j| sorted[j].1[i] / sorted[j].0);
            return Some((sorted.iter().map(|(size, _)| *size).collect(), vectors));
        }
    }
    None
}

/// Turns two columns into each other until they are at right angles; false if they are already.
fn rotates(first: &mut [f64], second: &mut [f64], right: f64) -> bool {
    let (a, b, c) = (dot(first, first), dot(second, second), dot(first, second));
    if c.abs() <= right * (a * b).sqrt() {
        return false;
    }
    let half = (b - a) / (2.0 * c);
    let tangent = half.signum() / (half.abs() + half.hypot(1.0));
    let cosine = tangent.hypot(1.0).recip();
    let sine = tangent * cosine;
    for (x, y) in first.iter_mut().zip(second) {
        (*x, *y) = (cosine * *x - sine * *y, sine * *x + cosine * *y);
    }
    true
}

/// Summed in lanes, which the compiler leaves one after the other otherwise.
fn dot(a: &[f64], b: &[f64]) -> f64 {
    let (mut sums, whole) = ([0.0; LANES], a.len() / LANES * LANES);
    for (a, b) in a.chunks_exact(LANES).zip(b.chunks_exact(LANES)) {
        for (sum, (a, b)) in sums.iter_mut().zip(a.iter().zip(b)) {
            *sum += a * b;
        }
    }
    let rest: f64 = a[whole..].iter().zip(&b[whole..]).map(|(a, b)| a * b).sum();
    sums.iter().sum::<f64>() + rest
}

#[cfg(test)]
mod tests;
