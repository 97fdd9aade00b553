//! Matrices by motions of grids that K2GG and M2GG add to the structure (DMIG).
//!
//! Grids that a matrix joins, directly or through others, become one element: a mass matrix of lumps is as many small ones.

use super::build::Builder;
use crate::corotation::Corotation;
use crate::element::Element;
use crate::matrix_element::MatrixElement;
use crate::springs;
use nalgebra::DMatrix;
use nastran::{Added, AddedMatrix, Dmig, InputError};
use std::collections::BTreeMap;
use std::sync::Arc;

/// Differences between the two triangles of a matrix that are rounding, over its largest term.
const ROUNDING: f64 = 1e-9;

/// A term: motions as (node, component 0 to 5), and what it is worth.
type Term = ([(usize, usize); 2], f64);

/// The elements of a selected matrix; masses are in units of mass whatever PARAM WTMASS is (`mass_factor`).
///
/// # Errors
/// If the matrix is not there, is complex or not symmetric, or names a motion that is not there.
pub(super) fn elements(
    builder: &Builder,
    cards: &[Dmig],
    matrix: &AddedMatrix,
    mass_factor: f64,
) -> Result<Vec<Arc<dyn Element>>, InputError> {
    let refuse = |what: &str, help: &str| {
        Err(InputError::at(&matrix.span, format!("DMIG {} {what}", matrix.name)).with_help(help))
    };
    let own: Vec<&Dmig> = cards.iter().filter(|card| card.name == matrix.name).collect();
    let Some(head) = own.iter().find_map(|card| card.head) else {
        return refuse("is not there", "give its head (DMIG NAME 0 6 ...) and its columns");
    };
    if head.is_complex || !head.is_symmetric {
        return refuse(
            "is not real and symmetric",
            "IFO 6 and TIN 1 or 2: stiffness and mass of a structure are symmetric",
        );
    }
    let terms = terms(builder, &own, &matrix.name)?;
    let scale = match matrix.to {
        Added::Stiffness => 1.0,
        Added::Mass => 1.0 / mass_factor,
    };
    let groups = groups(builder.nodes.len(), &terms);
    Ok(groups.into_iter().map(|terms| element(builder, matrix, &terms, scale)).collect())
}

/// The terms of both triangles, each once.
fn terms(builder: &Builder, cards: &[&Dmig], name: &str) -> Result<Vec<Term>, InputError> {
    let mut sum: BTreeMap<[(usize, usize); 2], f64> = BTreeMap::new();
    let user = format!("DMIG {name}");
    for card in cards {
        let Some(column) = card.column.first() else { continue };
        let column = builder.motion(*column, &user, &card.span)?;
        for (row, value) in card.rows.iter().zip(&card.values) {
            let row = builder.motion(*row, &user, &card.span)?;
            if let Some(before) = sum.insert([row, column], *value) {
                let message = format!("a term of DMIG {name} is given twice: {before} and {value}");
                return Err(InputError::at(&card.span, message).with_help("give every term once"));
            }
        }
    }
    let largest = sum.values().fold(0.0_f64, |most, value| most.max(value.abs()));
    let mut both = sum.clone();
    for ([row, column], value) in &sum {
        let image = both.entry([*column, *row]).or_insert(*value);
        if (*image - value).abs() > ROUNDING * largest {
            let message = format!(
                "DMIG {name} is not symmetric: {value} and {image} in the same place of both triangles"
            );
            return Err(InputError::at(&cards[0].span, message).with_help("give one triangle, or both alike"));
        }
    }
    Ok(both.into_iter().filter(|(_, value)| *value != 0.0).collect())
}

/// The leader of a node's set; ways to it are shortened.
fn find(leader: &mut [usize], mut node: usize) -> usize {
    while leader[node] != node {
        leader[node] = leader[leader[node]];
        node = leader[node];
    }
    node
}

/// Terms by sets of nodes that they join.
fn groups(count: usize, terms: &[Term]) -> Vec<Vec<Term>> {
    let mut leader: Vec<usize> = (0..count).collect();
    for ([(row, _), (column, _)], _) in terms {
        let (a, b) = (find(&mut leader, *row), find(&mut leader, *column));
        leader[a.max(b)] = a.min(b);
    }
    let mut groups: BTreeMap<usize, Vec<Term>> = BTreeMap::new();
    for term in terms {
        groups.entry(find(&mut leader, term.0[0].0)).or_default().push(*term);
    }
    groups.into_values().collect()
}

/// One element: each motion is along an axis of its grid's displacement system.
fn element(builder: &Builder, matrix: &AddedMatrix, terms: &[Term], scale: f64) -> Arc<dyn Element> {
    let mut nodes: Vec<usize> = terms.iter().map(|([(row, _), _], _)| *row).collect();
    nodes.sort_unstable();
    nodes.dedup();
    let dofs: Vec<usize> = nodes.iter().flat_map(|node| 6 * node..6 * node + 6).collect();
    let place = |dof: usize| {
        6 * nodes.binary_search(&(dof / 6)).expect("every term is between nodes of the group") + dof % 6
    };
    let mut local = DMatrix::zeros(dofs.len(), dofs.len());
    for ([row, column], value) in terms {
        for (i, along) in springs::motion(&builder.nodes, row.0, row.1) {
            for (j, across) in springs::motion(&builder.nodes, column.0, column.1) {
                local[(place(i), place(j))] += scale * value * along * across;
            }
        }
    }
    let element = match matrix.to {
        Added::Stiffness => MatrixElement::spring(0, &dofs, &local),
        Added::Mass => MatrixElement::mass(0, &dofs, &local),
    };
    let turning = match (matrix.to, nodes.len()) {
        (Added::Mass, 1) => Corotation::Node(0),
        _ => Corotation::Refused(format!(
            "DMIG {}: its matrix does not tell how it turns with large deflections",
            matrix.name
        )),
    };
    Arc::new(element.turning(turning))
}
