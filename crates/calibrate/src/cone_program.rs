//! The seam to Clarabel: one second-order cone program, and what its ending means to us.
//!
//! ```text
//! minimise   sum_c w_c t_c + mu (x - x0)' M (x - x0)
//! subject to || r_c + J_c (x - x_k) || <= sqrt(n) t_c     for each measured channel c
//!            A x <= b                                      neighbour and least-factor bounds
//! ```

use crate::bounds::BoundRow;
use clarabel::algebra::CscMatrix;
use clarabel::solver::{
    DefaultSettingsBuilder, DefaultSolver, IPSolver, NonnegativeConeT, SecondOrderConeT, SolverStatus,
    SupportedConeT,
};
use faer::Mat;

/// One linearised problem.
pub(crate) struct ConeProgram<'a> {
    /// Residuals at `from`, one vector a channel.
    pub(crate) residuals: &'a [Vec<f64>],
    /// Jacobians, angles by unknowns, one a channel.
    pub(crate) jacobians: &'a [Mat<f64>],
    /// Weight of each channel in paper 1, Eq. 8.
    pub(crate) weights: &'a [f64],
    /// Where it was linearised.
    pub(crate) from: &'a [f64],
    /// Where change is measured from.
    pub(crate) neutral: &'a [f64],
    /// Metric of change (block diagonal), unknowns by unknowns.
    pub(crate) metric: &'a Mat<f64>,
    /// Weight mu of the change.
    pub(crate) change_weight: f64,
    /// The bounds that take part.
    pub(crate) bounds: &'a [&'a BoundRow],
}

/// How a program ended without a solution.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum NoSolution {
    /// The bounds contradict each other.
    Infeasible,
    /// The solver gave up.
    Numerical,
}

impl ConeProgram<'_> {
    /// Solves the program: the unknowns.
    pub(crate) fn solve(&self) -> Result<Vec<f64>, NoSolution> {
        let size = self.from.len();
        let channels = self.residuals.len();
        let mut entries = Triplets::default();
        let mut right = Vec::new();
        let mut cones: Vec<SupportedConeT<f64>> = Vec::new();
        for (c, (residual, jacobian)) in self.residuals.iter().zip(self.jacobians).enumerate() {
            let root_n = (residual.len() as f64).sqrt();
            entries.push(right.len(), size + c, -1.0);
            right.push(0.0);
            for (i, r) in residual.iter().enumerate() {
                let mut at_origin = *r;
                for k in 0..size {
                    let value = jacobian[(i, k)];
                    at_origin -= value * self.from[k];
                    entries.push(right.len(), k, -value / root_n);
                }
                right.push(at_origin / root_n);
            }
            cones.push(SecondOrderConeT(residual.len() + 1));
        }
        for bound in self.bounds {
            for &(unknown, coefficient) in &bound.entries {
                entries.push(right.len(), unknown, coefficient);
            }
            right.push(bound.inside());
        }
        cones.push(NonnegativeConeT(self.bounds.len()));
        let constraint = entries.matrix(right.len(), size + channels);
        let (quadratic, linear) = self.change_cost(size, channels);
        self.run(&quadratic, &linear, &constraint, &right, &cones)
    }

    /// mu (x - x0)' M (x - x0) as Clarabel's half quadratic form (upper triangle), and the linear part.
    fn change_cost(&self, size: usize, channels: usize) -> (CscMatrix<f64>, Vec<f64>) {
        let mut entries = Triplets::default();
        let mut linear = vec![0.0; size + channels];
        for (j, slope) in linear.iter_mut().enumerate().take(size) {
            for i in 0..size {
                let value = 2.0 * self.change_weight * self.metric[(i, j)];
                if value == 0.0 {
                    continue;
                }
                *slope -= value * self.neutral[i];
                if i <= j {
                    entries.push(i, j, value);
                }
            }
        }
        linear[size..].copy_from_slice(self.weights);
        (entries.matrix(size + channels, size + channels), linear)
    }

    fn run(
        &self,
        quadratic: &CscMatrix<f64>,
        linear: &[f64],
        constraint: &CscMatrix<f64>,
        right: &[f64],
        cones: &[SupportedConeT<f64>],
    ) -> Result<Vec<f64>, NoSolution> {
        let settings =
            DefaultSettingsBuilder::default().verbose(false).build().map_err(|_| NoSolution::Numerical)?;
        let mut solver = DefaultSolver::new(quadratic, linear, constraint, right, cones, settings)
            .map_err(|_| NoSolution::Numerical)?;
        solver.solve();
        tracing::debug!(iterations = solver.info.iterations, status = ?solver.solution.status, "cone program");
        match solver.solution.status {
            SolverStatus::Solved | SolverStatus::AlmostSolved => {
                Ok(solver.solution.x[..self.from.len()].to_vec())
            }
            SolverStatus::PrimalInfeasible | SolverStatus::AlmostPrimalInfeasible => {
                Err(NoSolution::Infeasible)
            }
            _ => Err(NoSolution::Numerical),
        }
    }
}

/// Entries of a sparse matrix as they come.
#[derive(Default)]
struct Triplets {
    rows: Vec<usize>,
    columns: Vec<usize>,
    values: Vec<f64>,
}

impl Triplets {
    fn push(&mut self, row: usize, column: usize, value: f64) {
        self.rows.push(row);
        self.columns.push(column);
        self.values.push(value);
    }

    fn matrix(self, rows: usize, columns: usize) -> CscMatrix<f64> {
        CscMatrix::new_from_triplets(rows, columns, self.rows, self.columns, self.values)
    }
}
