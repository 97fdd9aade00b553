//! Motions that SPC (field D) and SPCD enforce: what the structure is held at instead of zero.

use super::Model;
use super::build::undefined;
use crate::constraints;
use nastran::{BulkData, InputError, Spc1, Spcd};

/// The enforced motions of a deck under its constraints ([`BulkData::bounded`]) and a load set on its `model`: six a node (m, rad; basic axes), in
/// the order of the model's nodes; none if all are zero. SPCD of the load set replace what SPC say. What follows a motion by a rigid element or an
/// equation follows an enforced one, too.
///
/// # Errors
/// If a motion follows itself in a circle, or an SPCD enforces what no SPC or SPC1 holds.
pub fn enforced_motions(
    bulk: &BulkData,
    model: &Model,
    load: Option<u32>,
) -> Result<Option<Vec<f64>>, InputError> {
    let cards: Vec<&Spc1> = bulk.constraints.iter().filter(|card| card.enforced != 0.0).collect();
    let of_set: Vec<&Spcd> = bulk.enforced.iter().filter(|card| Some(card.set) == load).collect();
    if cards.is_empty() && of_set.is_empty() {
        return Ok(None);
    }
    let place = |grid: u32| model.nodes.binary_search_by_key(&grid, |node| node.id).ok();
    // In the axes of each grid's displacement system.
    let mut own = vec![0.0; 6 * model.nodes.len()];
    for card in cards {
        // Grids that are not there have been said where they are clamped.
        for node in card.grids.iter().filter_map(|grid| place(*grid)) {
            for component in &card.components {
                own[6 * node + usize::from(*component) - 1] = card.enforced;
            }
            if card.components.is_empty() {
                own[6 * node] = card.enforced;
            }
        }
    }
    for card in of_set {
        let (grid, component) = card.motion;
        let user = format!("SPCD of set {}", card.set);
        let known = model.nodes.iter().map(|node| node.id).collect::<Vec<_>>();
        let node = place(grid).ok_or_else(|| undefined(&user, "GRID", grid, known.iter(), &card.span))?;
        let component = component.max(1);
        let is_held = |clamp: &super::Clamp| clamp.node == node && clamp.components.contains(&component);
        if !model.clamps.iter().any(is_held) {
            let message =
                format!("{user} enforces component {component} of GRID {grid}, which no SPC or SPC1 holds");
            return Err(InputError::at(&card.span, message)
                .with_help("hold it by SPC1 in the set that the subcase selects"));
        }
        own[6 * node + usize::from(component) - 1] = card.value;
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
