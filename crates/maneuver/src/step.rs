//! Exact stepping of a linear system whose inputs run linearly between samples.
//!
//! With `x' = A x + B u` and u linear over a step h, the step is a block of one matrix exponential (Van Loan 1978):
//! ```text
//! exp [ A h  B h  0 ]   [ Phi  G1+G0  G1 ]
//!     [  0    0   I ] = [  0     I     I ]      x1 = Phi x0 + G0 u0 + G1 u1
//!     [  0    0   0 ]   [  0     0     I ]
//! ```
//! so stepping has no error of its own, whatever the step and however stiff the system.

use faer::linalg::solvers::Solve;
use faer::{Mat, MatRef};

/// One step of fixed length.
#[derive(Debug, Clone)]
pub struct ExactStep {
    /// Phi, states by states.
    pub transition: Mat<f64>,
    /// G0, states by inputs: what the inputs at the beginning do.
    pub from_first: Mat<f64>,
    /// G1, states by inputs: what the inputs at the end do.
    pub from_last: Mat<f64>,
}

impl ExactStep {
    /// The step of length `h_s` of `x' = A x + B u`.
    pub fn new(a: MatRef<'_, f64>, b: MatRef<'_, f64>, h_s: f64) -> Self {
        let (states, inputs) = (a.nrows(), b.ncols());
        let mut block = Mat::zeros(states + 2 * inputs, states + 2 * inputs);
        for i in 0..states {
            for j in 0..states {
                block[(i, j)] = a[(i, j)] * h_s;
            }
            for j in 0..inputs {
                block[(i, states + j)] = b[(i, j)] * h_s;
            }
        }
        for j in 0..inputs {
            block[(states + j, states + inputs + j)] = 1.0;
        }
        let whole = exponential(block.as_ref());
        let last = whole.as_ref().submatrix(0, states + inputs, states, inputs).to_owned();
        let both = whole.as_ref().submatrix(0, states, states, inputs);
        Self {
            transition: whole.as_ref().submatrix(0, 0, states, states).to_owned(),
            from_first: both - &last,
            from_last: last,
        }
    }

    /// States at every sample: states by samples, starting with `x0`. `inputs` is inputs by samples.
    pub fn run(&self, x0: &[f64], inputs: MatRef<'_, f64>) -> Mat<f64> {
        let mut states = Mat::zeros(x0.len(), inputs.ncols());
        let mut x = Mat::from_fn(x0.len(), 1, |i, _| x0[i]);
        for sample in 0..inputs.ncols() {
            if sample > 0 {
                x = &self.transition * &x
                    + &self.from_first * inputs.subcols(sample - 1, 1)
                    + &self.from_last * inputs.subcols(sample, 1);
            }
            for i in 0..x0.len() {
                states[(i, sample)] = x[(i, 0)];
            }
        }
        states
    }
}

/// Matrix exponential by scaling, diagonal Pade approximant of order 8, and squaring (Golub and Van Loan, 11.3.1).
pub fn exponential(matrix: MatRef<'_, f64>) -> Mat<f64> {
    const ORDER: u32 = 8;
    let size = matrix.nrows();
    let norm = (0..size).map(|i| (0..size).map(|j| matrix[(i, j)].abs()).sum::<f64>()).fold(0.0, f64::max);
    let mut squarings = 0;
    let mut scale = 1.0;
    while norm * scale > 0.5 && squarings < 1000 {
        scale *= 0.5;
        squarings += 1;
    }
    let small = Mat::from_fn(size, size, |i, j| matrix[(i, j)] * scale);
    let mut coefficient = 1.0;
    let mut power = Mat::<f64>::identity(size, size);
    let (mut above, mut below) = (power.clone(), power.clone());
    for k in 1..=ORDER {
        coefficient *= f64::from(ORDER - k + 1) / f64::from(k * (2 * ORDER - k + 1));
        power = &small * &power;
        let sign = if k % 2 == 0 { 1.0 } else { -1.0 };
        above += faer::Scale(coefficient) * &power;
        below += faer::Scale(sign * coefficient) * &power;
    }
    let mut result = if size == 0 { above } else { below.partial_piv_lu().solve(&above) };
    for _ in 0..squarings {
        result = &result * &result;
    }
    result
}
