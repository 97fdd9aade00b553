//! Viscous dampers, and damping on modes.

use faer::{Mat, MatRef};
use nalgebra::DMatrix;
use nastran::Span;

/// A damper: forces (N, Nm) by velocities (m/s, rad/s) of some motions.
#[derive(Debug, Clone, PartialEq)]
pub struct Damper {
    /// What it is, such as `CDAMP 12`.
    pub owner: String,
    /// Where its card stands.
    pub span: Span,
    /// The motions, degrees of freedom of the g-set (6 * node + component - 1, basic axes, nodes in ascending grid number).
    dofs: Vec<usize>,
    matrix: DMatrix<f64>,
}

impl Damper {
    /// Of a matrix over motions of the g-set.
    pub(crate) fn new(owner: String, span: &Span, dofs: Vec<usize>, matrix: DMatrix<f64>) -> Self {
        Self { owner, span: span.clone(), dofs, matrix }
    }
}

/// Damping forces on modes by their velocities: Phi^T B Phi of shapes over the g-set, a column a mode.
pub fn modal_damping(dampers: &[Damper], shapes: MatRef<'_, f64>) -> Mat<f64> {
    let mut sum = Mat::zeros(shapes.ncols(), shapes.ncols());
    for damper in dampers {
        sum += on_modes(&damper.dofs, &damper.matrix, shapes);
    }
    sum
}

/// Phi^T a Phi of a matrix over some motions.
pub(crate) fn on_modes(dofs: &[usize], matrix: &DMatrix<f64>, shapes: MatRef<'_, f64>) -> Mat<f64> {
    let own = DMatrix::from_fn(dofs.len(), shapes.ncols(), |i, j| shapes[(dofs[i], j)]);
    let modal = own.transpose() * matrix * &own;
    Mat::from_fn(shapes.ncols(), shapes.ncols(), |i, j| modal[(i, j)])
}
