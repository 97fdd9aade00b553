//! Stability under loads that follow the structure: what the answer to a small motion gives back of that motion.

use super::near::Near;
use super::state::State;
use super::structure::LargeDeflection;
use crate::blocks::Noise;
use crate::unsymmetric::eigenvalues;
use faer::Mat;

/// Steps of Arnoldi's method at most: loads that follow have few eigenvalues that are not small.
const STEPS: usize = 20;

/// Steps before which its answer is not believed.
const LEAST_STEPS: usize = 5;

/// Change of the answer by a step, twice in a row, that is none any more.
const SETTLED: f64 = 1e-7;

impl LargeDeflection {
    /// The largest real eigenvalue of K^-1 A at an equilibrium, K the (symmetric) tangent stiffness and A the change of
    /// the loads by the motion: from one on, the loads push on faster than the structure holds back (divergence). Nothing
    /// if the state is no equilibrium of a stable structure. `near` are the loads about it.
    pub fn following_gain(&self, state: &State, near: &dyn Near) -> Option<f64> {
        let (map, inner) = (self.map(state), self.inner(state));
        let short: Vec<f64> = inner.forces.iter().zip(near.forces()).map(|(i, o)| i - o).collect();
        let factor = self.factored_tangent(state, &map, &inner.placed, &inner.local, &short)?;
        if factor.pivots().iter().any(|(_, pivot)| *pivot < 0.0) {
            return None;
        }
        let here = near.following_here();
        let answer = |v: &[f64]| -> Vec<f64> {
            let pulled = self.following_stiffness(state, &map, near, &here, v);
            let right = Mat::from_fn(v.len(), 1, |i, _| -pulled[i]);
            factor.solve(right.as_ref()).col(0).iter().copied().collect()
        };
        let start = Noise::new().extend(Mat::zeros(self.free_count(), 0).as_ref(), 1);
        let start = answer(&start.col(0).iter().copied().collect::<Vec<f64>>());
        largest_real(&start, answer)
    }
}

/// The largest real eigenvalue of an operator by Arnoldi's method from a vector; zero if all are complex or negative.
fn largest_real(start: &[f64], product: impl Fn(&[f64]) -> Vec<f64>) -> Option<f64> {
    let size = norm(start);
    if size == 0.0 {
        return Some(0.0);
    }
    let mut basis = vec![start.iter().map(|v| v / size).collect::<Vec<f64>>()];
    let mut columns: Vec<Vec<f64>> = Vec::new();
    let (mut answer, mut settled) = (0.0, 0);
    for step in 0..STEPS.min(start.len()) {
        let mut next = product(&basis[step]);
        let before = norm(&next);
        let mut column = vec![0.0; step + 1];
        // Twice: once leaves round-off along the others.
        for _ in 0..2 {
            for (share, other) in column.iter_mut().zip(&basis) {
                let part: f64 = other.iter().zip(&next).map(|(a, b)| a * b).sum();
                next.iter_mut().zip(other).for_each(|(next, other)| *next -= part * other);
                *share += part;
            }
        }
        let rest = norm(&next);
        column.push(rest);
        columns.push(column);
        let last = std::mem::replace(&mut answer, largest_of(&columns)?);
        settled = if (answer - last).abs() <= SETTLED { settled + 1 } else { 0 };
        if rest <= 1e-10 * before || (settled >= 2 && step + 1 >= LEAST_STEPS) {
            break;
        }
        basis.push(next.iter().map(|v| v / rest).collect());
    }
    Some(answer)
}

/// That of a Hessenberg matrix by columns.
fn largest_of(columns: &[Vec<f64>]) -> Option<f64> {
    let count = columns.len();
    let small = Mat::from_fn(count, count, |i, j| columns[j].get(i).copied().unwrap_or(0.0));
    let values = eigenvalues(small.as_ref())?;
    let real = values.iter().filter(|value| value.im.abs() <= 1e-6 * value.norm());
    Some(real.map(|value| value.re).fold(0.0, f64::max))
}

fn norm(v: &[f64]) -> f64 {
    v.iter().map(|v| v * v).sum::<f64>().sqrt()
}

#[cfg(test)]
mod tests {
    #[test]
    fn the_largest_real_eigenvalue_of_an_unsymmetric_operator_is_found() {
        // Eigenvalues 0.3 +- 2i, 0.7, -3.
        let product = |v: &[f64]| {
            vec![0.3 * v[0] - 2.0 * v[1], 2.0 * v[0] + 0.3 * v[1], 0.7 * v[2] + v[3], -3.0 * v[3]]
        };
        let found = super::largest_real(&[1.0, 0.5, -0.3, 0.8], product).expect("eigenvalues");
        assert!((found - 0.7).abs() < 1e-12, "{found} for 0.7");
    }
}
