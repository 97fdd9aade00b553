//! Exact stepping of a linear system `x' = A x + b u` with an input that runs linearly between its samples.
//!
//! The step is a block of the exponential of `[[A, b, 0], [0, 0, 1], [0, 0, 0]] dt` (Franklin, Powell and Workman,
//! *Digital Control of Dynamic Systems*, triangle hold), so it has no error of its own whatever the time step.

use faer::Mat;

/// One time step: `x1 = Phi x0 + g0 u0 + g1 u1`.
#[derive(Debug, Clone)]
pub(crate) struct Step {
    phi: Mat<f64>,
    g0: Vec<f64>,
    g1: Vec<f64>,
}

impl Step {
    /// The step of length `dt_s`.
    pub(crate) fn new(a: &Mat<f64>, b: &[f64], dt_s: f64) -> Self {
        let n = a.nrows();
        let block = Mat::from_fn(n + 2, n + 2, |i, j| match (i, j) {
            _ if i < n && j < n => a[(i, j)] * dt_s,
            _ if i < n && j == n => b[i] * dt_s,
            _ if i == n && j == n + 1 => 1.0,
            _ => 0.0,
        });
        let e = exponential(&block);
        Self {
            phi: e.as_ref().submatrix(0, 0, n, n).to_owned(),
            g0: (0..n).map(|i| e[(i, n)] - e[(i, n + 1)]).collect(),
            g1: (0..n).map(|i| e[(i, n + 1)]).collect(),
        }
    }

    /// States at all samples, from rest: one column a sample.
    pub(crate) fn run(&self, input: &[f64]) -> Mat<f64> {
        let n = self.phi.nrows();
        let mut states = Mat::zeros(n, input.len());
        for (at, pair) in input.windows(2).enumerate() {
            for i in 0..n {
                let free: f64 = (0..n).map(|j| self.phi[(i, j)] * states[(j, at)]).sum();
                states[(i, at + 1)] = free + self.g0[i] * pair[0] + self.g1[i] * pair[1];
            }
        }
        states
    }
}

/// Exponential of a matrix: Taylor's series of the matrix halved until it is small, squared back.
fn exponential(matrix: &Mat<f64>) -> Mat<f64> {
    const TERMS: u32 = 18;
    let n = matrix.nrows();
    let size = (0..n).map(|j| (0..n).map(|i| matrix[(i, j)].abs()).sum::<f64>()).fold(0.0, f64::max);
    let halvings =
        std::iter::successors(Some(size), |size| Some(size / 2.0)).take_while(|size| *size > 0.5).count();
    let factor = 0.5_f64.powi(i32::try_from(halvings).unwrap_or(i32::MAX));
    let small = Mat::from_fn(n, n, |i, j| matrix[(i, j)] * factor);
    let mut term = Mat::<f64>::identity(n, n);
    let mut sum = term.clone();
    for k in 1..=TERMS {
        let next = &term * &small;
        term = Mat::from_fn(n, n, |i, j| next[(i, j)] / f64::from(k));
        sum += &term;
    }
    for _ in 0..halvings {
        sum = &sum * &sum;
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_oscillator_driven_by_a_ramp_is_stepped_exactly() {
        // x'' + w^2 x = t from rest: x = t/w^2 - sin(w t)/w^3.
        let w = 7.0;
        let a = Mat::from_fn(2, 2, |i, j| [[0.0, 1.0], [-w * w, 0.0]][i][j]);
        let dt = 0.31;
        let input: Vec<f64> = (0..40).map(|k| f64::from(k) * dt).collect();
        let states = Step::new(&a, &[0.0, 1.0], dt).run(&input);
        for (k, t) in input.iter().enumerate() {
            let exact = t / (w * w) - (w * t).sin() / (w * w * w);
            assert!((states[(0, k)] - exact).abs() < 1e-11, "{k}");
        }
    }
}
