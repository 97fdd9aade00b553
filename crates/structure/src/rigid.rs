//! Rigid links (RBE2): the dependent nodes follow the independent node as one body.
//!
//! `u_d` = `u_i` + `theta_i` x (`x_d` - `x_i`), `theta_d` = `theta_i`, for the listed components. A link's independent node may
//! be a dependent node of another link; the chain is resolved until only independent motions are left.

use crate::model::Model;
use nastran::{InputError, Span};
use std::collections::BTreeMap;

/// A rigid link.
#[derive(Debug, Clone, PartialEq)]
pub struct RigidLink {
    /// Identification number.
    pub id: u32,
    /// Position of the independent node in [`Model::nodes`].
    pub independent: usize,
    /// Components of the dependent nodes that follow, digits 1 to 6.
    pub components: Vec<u8>,
    /// Positions of the dependent nodes.
    pub dependent: Vec<usize>,
    /// Where the card stands.
    pub span: Span,
}

/// A motion as a combination of others: (degree of freedom in the g-set, factor).
pub(crate) type Combination = Vec<(usize, f64)>;

/// What each dependent degree of freedom follows, in independent ones only.
pub(crate) fn dependence(model: &Model) -> Result<BTreeMap<usize, Combination>, InputError> {
    let mut direct: BTreeMap<usize, (Combination, &RigidLink)> = BTreeMap::new();
    for link in &model.rigid {
        for node in &link.dependent {
            for component in &link.components {
                let component = usize::from(*component) - 1;
                let row = follow(model, link, *node, component);
                if let Some((_, other)) = direct.insert(6 * node + component, (row, link)) {
                    return Err(twice(model, link, other, *node, component));
                }
            }
        }
    }
    resolve(model, direct)
}

/// One row of the rigid motion of `node` with the link's independent node.
fn follow(model: &Model, link: &RigidLink, node: usize, component: usize) -> Combination {
    let at = 6 * link.independent;
    let mut row = vec![(at + component, 1.0)];
    if component < 3 {
        // (theta x r)_c = theta_{c+1} r_{c+2} - theta_{c+2} r_{c+1}
        let arm = model.nodes[node].point - model.nodes[link.independent].point;
        let (next, last) = ((component + 1) % 3, (component + 2) % 3);
        row.push((at + 3 + next, arm[last]));
        row.push((at + 3 + last, -arm[next]));
    }
    row
}

/// Replaces dependent motions by what they follow until none is left. Each pass settles at least one, or there
/// is a circle.
fn resolve(
    model: &Model,
    mut open: BTreeMap<usize, (Combination, &RigidLink)>,
) -> Result<BTreeMap<usize, Combination>, InputError> {
    let mut done: BTreeMap<usize, Combination> = BTreeMap::new();
    while !open.is_empty() {
        let ready: Vec<usize> = open
            .iter()
            .filter(|(_, (row, _))| row.iter().all(|(dof, factor)| *factor == 0.0 || !open.contains_key(dof)))
            .map(|(dof, _)| *dof)
            .collect();
        if ready.is_empty() {
            let (dof, (_, link)) = open.iter().next().expect("the loop runs while it is not empty");
            let message = format!(
                "RBE2 {}: GRID {} follows itself in a circle of rigid links",
                link.id,
                model.nodes[dof / 6].id
            );
            let help = "one of the grids of the circle must be independent in all of them";
            return Err(InputError::at(&link.span, message).with_help(help));
        }
        for dof in ready {
            if let Some((row, _)) = open.remove(&dof) {
                let mut sum: BTreeMap<usize, f64> = BTreeMap::new();
                for (other, factor) in row.into_iter().filter(|(_, factor)| *factor != 0.0) {
                    match done.get(&other) {
                        Some(inner) => {
                            for (dof, f) in inner {
                                *sum.entry(*dof).or_default() += factor * f;
                            }
                        }
                        None => *sum.entry(other).or_default() += factor,
                    }
                }
                done.insert(dof, sum.into_iter().collect());
            }
        }
    }
    Ok(done)
}

fn twice(model: &Model, link: &RigidLink, other: &RigidLink, node: usize, component: usize) -> InputError {
    let (grid, component) = (model.nodes[node].id, component + 1);
    let message = if link.id == other.id {
        format!("RBE2 {}: GRID {grid} component {component} is dependent twice", link.id)
    } else {
        format!("RBE2 {}: GRID {grid} component {component} already depends on RBE2 {}", link.id, other.id)
    };
    InputError::at(&link.span, message)
        .with_help("a motion can follow only one rigid link; remove it from one of them")
}
