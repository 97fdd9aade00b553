//! Rigid elements: RBE2 (nodes follow one node), bodies that six motions of several nodes determine (RBAR, RTRPLT, RBE1) and RROD.

use super::equation::{Equation, solved_for};
use super::{Dependent, rigid_row};
use crate::model::Node;
use nalgebra::{Matrix6, Point3};
use nastran::{InputError, Rbe2, RigidBody, Rrod};

/// Share of a rigid rod's direction below which a component is across it.
const ACROSS: f64 = 1e-6;

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

/// A motion of a node: its position and component 0 to 5.
pub(crate) type NodeMotion = (usize, usize);

/// A rigid body that six `independent` motions determine and `dependent` ones follow.
///
/// # Errors
/// If the independent motions do not determine the body's, or a motion is both.
pub(crate) fn body(
    nodes: &[Node],
    card: &RigidBody,
    independent: &[NodeMotion],
    dependent: &[NodeMotion],
) -> Result<Vec<Dependent>, InputError> {
    let owner = card.name();
    let about = independent.first().map_or_else(Point3::origin, |(node, _)| nodes[*node].point);
    let rows: Vec<_> = independent.iter().map(|(node, c)| rigid_row(&nodes[*node], *c, &about)).collect();
    let inverse = (rows.len() == 6).then(|| Matrix6::from_rows(&rows)).and_then(Matrix6::try_inverse);
    let inverse =
        inverse.filter(|inverse| inverse.iter().all(|value| value.is_finite() && value.abs() < 1e12));
    let Some(inverse) = inverse else {
        let message = format!("{owner}: its independent motions do not determine the motion of the body");
        let help = "name six motions that hold a rigid body, such as 123456 of one grid";
        return Err(InputError::at(&card.span, message).with_help(help));
    };
    if let Some((node, component)) = dependent.iter().find(|motion| independent.contains(motion)) {
        let grid = nodes[*node].id;
        let message =
            format!("{owner}: GRID {grid} component {} is independent and dependent", component + 1);
        return Err(InputError::at(&card.span, message).with_help("name it in one of the two lists only"));
    }
    let rows = dependent.iter().map(|(node, component)| {
        let factors = rigid_row(&nodes[*node], *component, &about) * inverse;
        let sources = independent.iter().map(|(node, component)| 6 * node + component);
        let row = sources.zip(factors.iter().copied()).filter(|(_, f)| f.abs() > 1e-14).collect();
        Dependent { dof: 6 * node + component, row, owner: owner.clone(), span: card.span.clone() }
    });
    Ok(rows.collect())
}

/// A rigid rod between two nodes: the dependent motion follows so that their distance stays.
///
/// # Errors
/// If the rod has no length or the dependent motion is across it.
pub(crate) fn rod(nodes: &[Node], card: &Rrod, ends: [usize; 2]) -> Result<Vec<Dependent>, InputError> {
    let owner = format!("RROD {}", card.id);
    let along = nodes[ends[1]].point - nodes[ends[0]].point;
    let own = |end: usize, component: usize| {
        let sign = if end == 0 { -1.0 } else { 1.0 };
        sign * nodes[ends[end]].axes.column(component).dot(&along)
    };
    let (end, digit) = card.dependent;
    let component = usize::from(digit) - 1;
    if own(end, component).abs() <= ACROSS * along.norm() || along.norm() == 0.0 {
        let message = format!(
            "{owner}: component {digit} of GRID {} is across the rod, or the rod has no length",
            card.grids[end]
        );
        return Err(InputError::at(&card.span, message)
            .with_help("let a component follow that is along the rod, best the one most so"));
    }
    let terms = [0, 1].into_iter().flat_map(|end| (0..3).map(move |component| (end, component)));
    let equation: Equation =
        terms.map(|(end, component)| (6 * ends[end] + component, own(end, component))).collect();
    solved_for(&[equation], &[6 * ends[end] + component], &owner, &card.span)
}
