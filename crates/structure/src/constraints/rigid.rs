//! Rigid elements: RBE2 (nodes follow one node) and RBAR (two ends, six independent motions between them).

use super::{Dependent, rigid_row};
use crate::model::Node;
use nalgebra::Matrix6;
use nastran::{InputError, Rbar, Rbe2};

/// RBE2: the card's components of the nodes at positions `dependent` follow the node at `independent`.
pub(crate) fn link(nodes: &[Node], card: &Rbe2, independent: usize, dependent: &[usize]) -> Vec<Dependent> {
    let (owner, components) = (format!("RBE2 {}", card.id), &card.components);
    let about = nodes[independent].point;
    let mut rows = Vec::with_capacity(components.len() * dependent.len());
    for node in dependent {
        for component in components {
            let component = usize::from(*component) - 1;
            let motion = rigid_row(&nodes[*node], component, &about);
            // The independent node's own motions, turned to its axes.
            let factor = |k: usize| {
                let axis = nodes[independent].axes.column(k % 3);
                motion.fixed_columns::<3>(3 * (k / 3)).transpose().dot(&axis)
            };
            let row = (0..6).map(|k| (6 * independent + k, factor(k))).filter(|(_, f)| *f != 0.0).collect();
            let dof = 6 * node + component;
            rows.push(Dependent { dof, row, owner: owner.clone(), span: card.span.clone() });
        }
    }
    rows
}

/// RBAR between the nodes at positions `ends`.
///
/// # Errors
/// If the independent motions do not determine the bar's, or a motion is both.
pub(crate) fn bar(nodes: &[Node], card: &Rbar, ends: [usize; 2]) -> Result<Vec<Dependent>, InputError> {
    let owner = format!("RBAR {}", card.id);
    let motions = |lists: &[Vec<u8>; 2]| -> Vec<(usize, usize)> {
        let of = |end: usize| lists[end].iter().map(move |c| (ends[end], usize::from(*c) - 1));
        of(0).chain(of(1)).collect()
    };
    let independent = motions(&card.independent);
    let about = nodes[ends[0]].point;
    let rows: Vec<_> = independent.iter().map(|(node, c)| rigid_row(&nodes[*node], *c, &about)).collect();
    let inverse = (rows.len() == 6).then(|| Matrix6::from_rows(&rows)).and_then(Matrix6::try_inverse);
    let inverse =
        inverse.filter(|inverse| inverse.iter().all(|value| value.is_finite() && value.abs() < 1e12));
    let Some(inverse) = inverse else {
        let message = format!("{owner}: its independent motions do not determine the motion of the bar");
        let help =
            "CNA and CNB together must name six motions that hold a rigid body, such as 123456 at one end";
        return Err(InputError::at(&card.span, message).with_help(help));
    };
    let mut dependent = motions(&card.dependent);
    if dependent.is_empty() {
        let all = ends.iter().flat_map(|node| (0..6).map(|component| (*node, component)));
        dependent = all.filter(|motion| !independent.contains(motion)).collect();
    }
    if let Some((node, component)) = dependent.iter().find(|motion| independent.contains(motion)) {
        let grid = nodes[*node].id;
        let message =
            format!("{owner}: GRID {grid} component {} is independent and dependent", component + 1);
        return Err(InputError::at(&card.span, message).with_help("name it in one of CN and CM only"));
    }
    let rows = dependent.into_iter().map(|(node, component)| {
        let factors = rigid_row(&nodes[node], component, &about) * inverse;
        let sources = independent.iter().map(|(node, component)| 6 * node + component);
        let row = sources.zip(factors.iter().copied()).filter(|(_, f)| f.abs() > 1e-14).collect();
        Dependent { dof: 6 * node + component, row, owner: owner.clone(), span: card.span.clone() }
    });
    Ok(rows.collect())
}
