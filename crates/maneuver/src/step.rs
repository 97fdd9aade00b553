//! Exact stepping of a linear system whose inputs run linearly between samples.
//!
//! With `x' = A x + B u` and u linear over a step h, the step is a block of one matrix exponential (Van Loan 1978):
//! ```text
//! exp [ A h  B h  0 ]   [ Phi  G1+G0  G1 ]
//!     [  0    0   I ] = [  0     I     I ]      x1 = Phi x0 + G0 u0 + G1 u1
//!     [  0    0   0 ]   [  0     0     I ]
//! ```
//! so stepping has no error of its own, whatever the step and however stiff the system.
//!
//! Long histories of few outputs do not need every state. With `z = x - G1 u` the step is `z1 = Phi z0 + E u0`,
//! `E = G0 + Phi G1`; a block of T samples then is one product of known matrices with its inputs and its first z, and
//! only the first z of every block is stepped ([`ExactStep::outputs`]).

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

/// Samples in a block of [`ExactStep::outputs`].
const BLOCK: usize = 32;

impl ExactStep {
    /// Outputs `y = C x + D u` at every sample, outputs by samples: the same as of [`ExactStep::run`], at a fraction of
    /// its time for long histories. `inputs` is inputs by samples, with one sample at least.
    pub fn outputs(
        &self,
        x0: &[f64],
        inputs: MatRef<'_, f64>,
        c: MatRef<'_, f64>,
        d: MatRef<'_, f64>,
    ) -> Mat<f64> {
        let (states, m, p) = (self.transition.nrows(), inputs.nrows(), c.nrows());
        let samples = inputs.ncols();
        let blocks = samples.div_ceil(BLOCK);
        let drive = &self.from_first + &self.transition * &self.from_last;
        let kernels = Kernels::new(self.transition.as_ref(), drive.as_ref(), c);
        // the last block is filled up with zeros, whose outputs are not looked at
        let stacked = Mat::from_fn(m * BLOCK, blocks, |row, block| {
            let sample = block * BLOCK + row / m;
            if sample < samples { inputs[(row % m, sample)] } else { 0.0 }
        });
        let ends = &kernels.to_end * &stacked;
        let mut firsts = Mat::zeros(states, blocks);
        let first_input = inputs.subcols(0, 1);
        let mut z = Mat::from_fn(states, 1, |i, _| x0[i]) - &self.from_last * first_input;
        for block in 0..blocks {
            firsts.as_mut().subcols_mut(block, 1).copy_from(&z);
            z = &kernels.over_block * &z + ends.as_ref().subcols(block, 1);
        }
        let inside = &kernels.free * &firsts + &kernels.forced * &stacked;
        let direct = (c * &self.from_last + d) * inputs;
        Mat::from_fn(p, samples, |row, k| direct[(row, k)] + inside[((k % BLOCK) * p + row, k / BLOCK)])
    }
}

/// The matrices that a block of samples is multiplied with.
struct Kernels {
    /// C Phi^j, one below the other.
    free: Mat<f64>,
    /// Block Toeplitz: `C Phi^(j-1-i) E` for i < j.
    forced: Mat<f64>,
    /// `Phi^(T-1-i) E`, side by side.
    to_end: Mat<f64>,
    /// Phi^T.
    over_block: Mat<f64>,
}

impl Kernels {
    fn new(phi: MatRef<'_, f64>, drive: MatRef<'_, f64>, c: MatRef<'_, f64>) -> Self {
        let (states, m, p) = (phi.nrows(), drive.ncols(), c.nrows());
        let mut free = Mat::zeros(p * BLOCK, states);
        let mut to_end = Mat::zeros(states, m * BLOCK);
        let mut rows = c.to_owned();
        let mut columns = drive.to_owned();
        for j in 0..BLOCK {
            free.as_mut().subrows_mut(j * p, p).copy_from(&rows);
            to_end.as_mut().subcols_mut((BLOCK - 1 - j) * m, m).copy_from(&columns);
            rows = &rows * phi;
            columns = phi * &columns;
        }
        let pulses = &free * drive;
        let forced = Mat::from_fn(p * BLOCK, m * BLOCK, |row, column| {
            let (j, i) = (row / p, column / m);
            if i < j { pulses[((j - 1 - i) * p + row % p, column % m)] } else { 0.0 }
        });
        let over_block = (0..BLOCK.ilog2()).fold(phi.to_owned(), |power, _| &power * &power);
        Self { free, forced, to_end, over_block }
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
