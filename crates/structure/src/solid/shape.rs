//! What the families of solids differ in: shape functions, strain modes and quadrature over the parent shape.
//!
//! Arrays are padded with zeros to the largest family, eight corners and 21 modes, so that one element routine
//! serves all.

use crate::solid_material::COMPONENTS;
use nalgebra::{Matrix3, Matrix6, SMatrix, SVector};
use std::fmt::Debug;

/// Shape functions at a place, one a corner.
pub(crate) type Values = SVector<f64, 8>;
/// Their derivatives by the three local coordinates (rows).
pub(crate) type Gradients = SMatrix<f64, 3, 8>;
/// Strains of the modes (columns) in local coordinates: xx, yy, zz, xy, yz, zx, engineering shear.
pub(crate) type ModeStrains = SMatrix<f64, 6, 21>;

/// A place in the parent shape and its weight.
#[derive(Debug, Clone, Copy)]
pub(crate) struct QuadraturePoint {
    pub(crate) at: [f64; 3],
    pub(crate) weight: f64,
}

/// A family of solids.
pub(crate) trait Shape: Debug + Sync {
    /// Name of its card.
    fn card(&self) -> &'static str;
    /// Local coordinates of its middle, where the modes' Jacobian is taken.
    fn middle(&self) -> [f64; 3];
    /// Shape functions.
    fn values(&self, at: [f64; 3]) -> Values;
    /// Their derivatives.
    fn gradients(&self, at: [f64; 3]) -> Gradients;
    /// Number of strain modes.
    fn mode_count(&self) -> usize;
    /// Their strains; their integral over the parent shape is zero.
    fn mode_strains(&self, at: [f64; 3]) -> ModeStrains;
    /// Quadrature of the stiffness.
    fn stiffness_points(&self) -> Vec<QuadraturePoint>;
    /// Quadrature of the mass, exact for the shape with straight edges.
    fn mass_points(&self) -> Vec<QuadraturePoint>;
    /// Quadrature of the stiffness with grids on the edges, exact where edges are straight and grids in their middle.
    fn quadratic_points(&self) -> Vec<QuadraturePoint>;
    /// Quadrature of the mass with grids on the edges.
    fn quadratic_mass_points(&self) -> Vec<QuadraturePoint>;
}

/// Gauss' rule with two points on -1 to 1, exact to degree 3.
pub(crate) fn gauss_2() -> [(f64, f64); 2] {
    let x = 1.0 / 3.0_f64.sqrt();
    [(-x, 1.0), (x, 1.0)]
}

/// Gauss' rule with three points on -1 to 1, exact to degree 5.
pub(crate) fn gauss_3() -> [(f64, f64); 3] {
    let x = 0.6_f64.sqrt();
    [(-x, 5.0 / 9.0), (0.0, 8.0 / 9.0), (x, 5.0 / 9.0)]
}

/// The six components (engineering shear) of the strain G E G^T from those of E.
pub(crate) fn strain_transformation(g: &Matrix3<f64>) -> Matrix6<f64> {
    let mut t = Matrix6::zeros();
    for (column, (k, l)) in COMPONENTS.into_iter().enumerate() {
        for (row, (i, j)) in COMPONENTS.into_iter().enumerate() {
            // An engineering shear stands with one half at two places of E, and is twice its entry of G E G^T.
            let both = g[(i, k)] * g[(j, l)] + g[(i, l)] * g[(j, k)];
            t[(row, column)] = if i == j { 0.5 * both } else { both };
        }
    }
    t
}
