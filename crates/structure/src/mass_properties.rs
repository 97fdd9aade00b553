//! Mass, centre of gravity and moments of inertia of a structure, from the rigid motions of its mass matrix.
//!
//! With R the six rigid motions about a point, `R^T M R = [m E, -m [c]; m [c], I]`; the inertia is moved from that
//! point to the centre by Steiner's theorem.

use crate::assemble::mass_matrix;
use crate::element::Element;
use crate::model::Model;
use crate::system::System;
use nalgebra::{DMatrix, Matrix3, Matrix6, Point3, Vector3};
use rayon::prelude::*;
use std::sync::Arc;

/// Mass properties of a whole structure, basic axes.
#[derive(Debug, Clone, PartialEq)]
pub struct MassProperties {
    /// Mass, kg.
    pub mass_kg: f64,
    /// Centre of gravity, m; the first node if there is no mass.
    pub centre: Point3<f64>,
    /// Inertia matrix about the centre, kg m^2; products of inertia enter with a minus sign.
    pub inertia_kg_m2: Matrix3<f64>,
}

impl MassProperties {
    /// Of a model that is not assembled: the sum over its elements.
    pub fn of_model(model: &Model) -> Self {
        let points: Vec<Point3<f64>> = model.nodes.iter().map(|node| node.point).collect();
        let about = points.first().copied().unwrap_or_else(Point3::origin);
        let one = |element: &Arc<dyn Element>| {
            let dofs = element.dofs();
            let mass = mass_matrix(model, element, &dofs)?;
            let rigid = DMatrix::from_fn(dofs.len(), 6, |i, j| {
                if model.nodes[dofs[i] / 6].is_scalar {
                    0.0
                } else {
                    rigid_entry(&points, &about, dofs[i], j)
                }
            });
            Some(Matrix6::from_fn(|i, j| (rigid.column(i).transpose() * &mass * rigid.column(j))[(0, 0)]))
        };
        let each: Vec<Option<Matrix6<f64>>> = model.elements.par_iter().map(one).collect();
        from_total(&each.into_iter().flatten().sum(), &about)
    }
}

/// Displacement of a degree of freedom of the g-set in a rigid motion about a point (x, y, z, then the rotations).
fn rigid_entry(points: &[Point3<f64>], about: &Point3<f64>, dof: usize, motion: usize) -> f64 {
    let (component, arm) = (dof % 6, points[dof / 6] - about);
    if component == motion {
        return 1.0;
    }
    if component > 2 || motion < 3 {
        return 0.0;
    }
    let axis = motion - 3;
    if component == (axis + 1) % 3 {
        -arm[(axis + 2) % 3]
    } else if component == (axis + 2) % 3 {
        arm[(axis + 1) % 3]
    } else {
        0.0
    }
}

impl System {
    /// Mass, centre of gravity and inertia of the whole structure, clamped nodes included.
    pub fn mass_properties(&self) -> MassProperties {
        // About a point of the structure itself: far from the origin the centre would lose digits.
        let about = self.points().first().copied().unwrap_or_else(Point3::origin);
        let rigid = self.rigid_body(&about);
        let momentum = self.inertia_loads(rigid.as_ref());
        let total = rigid.transpose() * &momentum;
        from_total(&Matrix6::from_fn(|i, j| total[(i, j)]), &about)
    }
}

/// From `R^T M R` about a point.
fn from_total(total: &Matrix6<f64>, about: &Point3<f64>) -> MassProperties {
    let mass_kg = (total[(0, 0)] + total[(1, 1)] + total[(2, 2)]) / 3.0;
    let moment = Vector3::new(
        0.5 * (total[(1, 5)] - total[(2, 4)]),
        0.5 * (total[(2, 3)] - total[(0, 5)]),
        0.5 * (total[(0, 4)] - total[(1, 3)]),
    );
    let arm = if mass_kg > 0.0 { moment / mass_kg } else { Vector3::zeros() };
    let inertia = Matrix3::from_fn(|i, j| 0.5 * (total[(3 + i, 3 + j)] + total[(3 + j, 3 + i)]));
    let steiner = (Matrix3::identity() * arm.norm_squared() - arm * arm.transpose()) * mass_kg;
    MassProperties { mass_kg, centre: about + arm, inertia_kg_m2: inertia - steiner }
}
