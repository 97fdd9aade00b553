//! Mass, centre of gravity and moments of inertia of a structure, from the rigid motions of its mass matrix.
//!
//! With R the six rigid motions about a point, `R^T M R = [m E, -m [c]; m [c], I]`; the inertia is moved from that
//! point to the centre by Steiner's theorem.

use crate::system::System;
use nalgebra::{Matrix3, Point3, Vector3};

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

/// Of the whole g-set, clamped and dependent nodes included.
pub(crate) fn of(system: &System) -> MassProperties {
    // About a point of the structure itself: far from the origin the centre would lose digits.
    let about = system.points().first().copied().unwrap_or_else(Point3::origin);
    let rigid = system.rigid_body(&about);
    let momentum = system.inertia_loads(rigid.as_ref());
    let total = rigid.transpose() * &momentum;
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
