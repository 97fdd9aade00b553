//! Motions that follow others: rigid elements, weighted means, constraint equations, and their elimination.
//!
//! Every kind of constraint gives rows "this motion is that combination of others" over the grids' own displacement
//! axes (degree of freedom 6 * node + component - 1). A motion that is followed may follow others itself; chains are
//! resolved until only independent motions are left.

pub(crate) mod average;
pub(crate) mod equation;
pub(crate) mod joint;
pub(crate) mod rigid;
pub(crate) mod spline;

use crate::model::Node;
use nalgebra::{RowVector6, Vector3};
use nastran::{InputError, Span};
use std::collections::BTreeMap;

/// A motion as a combination of others: (degree of freedom, factor).
pub(crate) type Combination = Vec<(usize, f64)>;

/// A motion that follows others.
#[derive(Debug, Clone, PartialEq)]
pub struct Dependent {
    /// The motion: 6 * node + component - 1, in the axes of the grid's displacement system.
    pub dof: usize,
    /// What it follows: motion and factor.
    pub row: Vec<(usize, f64)>,
    /// The card that says so, such as `RBE2 12`.
    pub owner: String,
    /// Where the card stands.
    pub span: Span,
}

/// What six rigid motions (displacements, rotations about `about`, basic axes) make of one motion of a node:
/// component 0 to 5 in the node's own axes.
pub(crate) fn rigid_row(node: &Node, component: usize, about: &nalgebra::Point3<f64>) -> RowVector6<f64> {
    let direction: Vector3<f64> = node.axes.column(component % 3).into();
    let mut row = RowVector6::zeros();
    if component < 3 {
        let lever = (node.point - about).cross(&direction);
        row.fixed_columns_mut::<3>(0).copy_from(&direction.transpose());
        row.fixed_columns_mut::<3>(3).copy_from(&lever.transpose());
    } else {
        row.fixed_columns_mut::<3>(3).copy_from(&direction.transpose());
    }
    row
}

/// What each dependent motion follows, in independent ones only.
pub(crate) fn resolved(
    nodes: &[Node],
    dependents: &[Dependent],
) -> Result<BTreeMap<usize, Combination>, InputError> {
    let mut open: BTreeMap<usize, &Dependent> = BTreeMap::new();
    for dependent in dependents {
        if let Some(other) = open.insert(dependent.dof, dependent) {
            return Err(twice(nodes, dependent, other));
        }
    }
    // Each pass settles at least one, or there is a circle.
    let mut done: BTreeMap<usize, Combination> = BTreeMap::new();
    while !open.is_empty() {
        let ready: Vec<usize> = open
            .iter()
            .filter(|(_, item)| {
                item.row.iter().all(|(dof, factor)| *factor == 0.0 || !open.contains_key(dof))
            })
            .map(|(dof, _)| *dof)
            .collect();
        if ready.is_empty() {
            let (dof, item) = open.iter().next().expect("the loop runs while it is not empty");
            let message = format!(
                "{}: GRID {} follows itself in a circle of rigid links",
                item.owner,
                nodes[dof / 6].id
            );
            let help = "one of the grids of the circle must be independent in all of them";
            return Err(InputError::at(&item.span, message).with_help(help));
        }
        for dof in ready {
            if let Some(item) = open.remove(&dof) {
                let row = settled(&item.row, &done);
                done.insert(dof, row);
            }
        }
    }
    Ok(done)
}

/// A row with what is settled put in the place of dependent motions.
fn settled(row: &[(usize, f64)], done: &BTreeMap<usize, Combination>) -> Combination {
    let mut sum: BTreeMap<usize, f64> = BTreeMap::new();
    for (other, factor) in row.iter().filter(|(_, factor)| *factor != 0.0) {
        match done.get(other) {
            Some(inner) => inner.iter().for_each(|(dof, f)| *sum.entry(*dof).or_default() += factor * f),
            None => *sum.entry(*other).or_default() += factor,
        }
    }
    sum.into_iter().collect()
}

fn twice(nodes: &[Node], item: &Dependent, other: &Dependent) -> InputError {
    let (grid, component) = (nodes[item.dof / 6].id, item.dof % 6 + 1);
    let message = if item.owner == other.owner {
        format!("{}: GRID {grid} component {component} is dependent twice", item.owner)
    } else {
        format!("{}: GRID {grid} component {component} already depends on {}", item.owner, other.owner)
    };
    InputError::at(&item.span, message)
        .with_help("a motion can follow only one rigid link; remove it from one of them")
}
