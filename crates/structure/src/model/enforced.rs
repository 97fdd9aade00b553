//! Motions that SPC enforces (field D): what the structure is held at instead of zero.

use super::Model;
use crate::constraints;
use nastran::{BulkData, InputError, Spc1};

/// The enforced motions of a deck under its constraints ([`BulkData::bounded`]) on its `model`: six a node (m, rad; basic axes), in the order of the
/// model's nodes; none if all are zero. What follows a motion by a rigid element or an equation follows an enforced one, too.
///
/// # Errors
/// If a motion follows itself in a circle.
pub fn enforced_motions(bulk: &BulkData, model: &Model) -> Result<Option<Vec<f64>>, InputError> {
    let cards: Vec<&Spc1> = bulk.constraints.iter().filter(|card| card.enforced != 0.0).collect();
    if cards.is_empty() {
        return Ok(None);
    }
    // In the axes of each grid's displacement system.
    let mut own = vec![0.0; 6 * model.nodes.len()];
    for card in cards {
        // Grids that are not there have been said where they are clamped.
        let places =
            card.grids.iter().filter_map(|grid| model.nodes.binary_search_by_key(grid, |n| n.id).ok());
        for node in places {
            for component in &card.components {
                own[6 * node + usize::from(*component) - 1] = card.enforced;
            }
            if card.components.is_empty() {
                own[6 * node] = card.enforced;
            }
        }
    }
    for (dof, row) in constraints::resolved(&model.nodes, &model.dependents)? {
        own[dof] = row.iter().map(|(source, factor)| factor * own[*source]).sum();
    }
    let mut basic = vec![0.0; own.len()];
    for (node, axes) in model.nodes.iter().map(|node| node.axes).enumerate() {
        for (row, column) in (0..9).map(|at| (at / 3, at % 3)) {
            for first in [0, 3] {
                basic[6 * node + first + row] += axes[(row, column)] * own[6 * node + first + column];
            }
        }
    }
    Ok(Some(basic))
}
