//! Weighted means (RBE3): the reference node follows the rigid motion that fits its group best.
//!
//! With r the row of a member's motion under six rigid motions about the reference node, the fit minimises the sum of
//! weight times (r p - u)^2; the reference moves by p. A load on the reference is so distributed to the members that
//! forces and moments are kept. Rotations of members count with the square of the group's mean radius, which makes the
//! weights of displacements and rotations comparable.

use super::equation::{Equation, solved_for};
use super::{Dependent, rigid_row};
use crate::model::Node;
use nalgebra::{Matrix6, Vector6};
use nastran::{InputError, Rbe3};
use std::collections::BTreeSet;

/// A share of the largest eigenvalue below which the group does not determine a rigid motion.
const UNDETERMINED: f64 = 1e-12;

/// A member's motion: node, component 0 to 5, weight.
pub(crate) struct Member {
    pub(crate) node: usize,
    pub(crate) component: usize,
    pub(crate) weight: f64,
}

/// The rows of an RBE3; `um` are the motions made dependent instead of the reference's, if any.
///
/// # Errors
/// If the group does not determine what follows it.
pub(crate) fn mean(
    nodes: &[Node],
    card: &Rbe3,
    reference: usize,
    members: &[Member],
    um: &[usize],
) -> Result<Vec<Dependent>, InputError> {
    let owner = format!("RBE3 {}", card.id);
    let about = nodes[reference].point;
    // Of the grids, however many components of each are in the group.
    let grids: BTreeSet<usize> = members.iter().map(|member| member.node).collect();
    let radius_m = mean_radius(grids.iter().map(|node| (nodes[*node].point - about).norm()));
    // Rotations in units of the radius, so that the matrix has one unit.
    let scale = Vector6::from_fn(|k, _| if k < 3 { 1.0 } else { radius_m });
    let mut normal = Matrix6::zeros();
    let mut weighted = Vec::with_capacity(members.len());
    for member in members {
        let row = rigid_row(&nodes[member.node], member.component, &about);
        let row = row.component_div(&scale.transpose());
        let weight = if member.component < 3 { member.weight } else { member.weight * radius_m * radius_m };
        normal += row.transpose() * row * weight;
        weighted.push((6 * member.node + member.component, row.transpose() * weight));
    }
    let (inverse, loose) = pseudo_inverse(&normal);
    let mut equations: Vec<Equation> = Vec::new();
    for component in &card.components {
        let component = usize::from(*component) - 1;
        let own = rigid_row(&nodes[reference], component, &about).component_div(&scale.transpose());
        if loose.iter().any(|direction| (own * direction).x.abs() > 1e-6 * own.norm()) {
            let message = format!(
                "{owner}: its group does not determine component {} of GRID {}",
                component + 1,
                nodes[reference].id
            );
            let help =
                "three grids that are not in one line determine all six; or leave the component out of REFC";
            return Err(InputError::at(&card.span, message).with_help(help));
        }
        let fit = own * inverse;
        let mut equation = vec![(6 * reference + component, 1.0)];
        equation.extend(weighted.iter().map(|(dof, column)| (*dof, -(fit * column).x)));
        equations.push(equation);
    }
    let own: Vec<usize> =
        card.components.iter().map(|component| 6 * reference + usize::from(*component) - 1).collect();
    solved_for(&equations, if um.is_empty() { &own } else { um }, &owner, &card.span)
}

/// The mean of the members' distances from the reference, m; one if all are there.
pub(crate) fn mean_radius(distances: impl ExactSizeIterator<Item = f64>) -> f64 {
    let count = distances.len().max(1) as f64;
    let mean = distances.sum::<f64>() / count;
    if mean > 0.0 { mean } else { 1.0 }
}

/// The inverse on what is determined, and the directions that are not.
fn pseudo_inverse(normal: &Matrix6<f64>) -> (Matrix6<f64>, Vec<Vector6<f64>>) {
    let eigen = normal.symmetric_eigen();
    let least = UNDETERMINED * eigen.eigenvalues.amax();
    let mut inverse = Matrix6::zeros();
    let mut loose = Vec::new();
    for (value, vector) in eigen.eigenvalues.iter().zip(eigen.eigenvectors.column_iter()) {
        if *value > least {
            inverse += vector * vector.transpose() / *value;
        } else {
            loose.push(vector.into_owned());
        }
    }
    (inverse, loose)
}
