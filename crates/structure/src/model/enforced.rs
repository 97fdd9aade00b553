//! Motions that SPC enforces (field D): what the structure is held at instead of zero.

use super::build::Builder;
use crate::laminate::ShearModel;
use nastran::{BulkData, InputError, Spc1};
use std::collections::BTreeSet;

/// The enforced motions of a deck under its constraints ([`BulkData::bounded`]): six a node (m, rad; basic axes), in the order of the
/// model's nodes; none if all are zero.
///
/// # Errors
/// If a grid is not there, or is tied to others by a rigid element or an equation, whose motion it would share.
pub fn enforced_motions(bulk: &BulkData) -> Result<Option<Vec<f64>>, InputError> {
    let cards: Vec<&Spc1> = bulk.constraints.iter().filter(|card| card.enforced != 0.0).collect();
    if cards.is_empty() {
        return Ok(None);
    }
    let builder = Builder::new(bulk, ShearModel::Equilibrium)?;
    let tied = tied(bulk);
    let mut motions = vec![0.0; 6 * builder.nodes.len()];
    for card in cards {
        for grid in &card.grids {
            let node = builder.node(*grid, "SPC", &card.span)?;
            if tied.contains(grid) {
                let message = format!(
                    "SPC enforces a motion of grid {grid}, which a rigid element or an equation ties to others"
                );
                return Err(InputError::at(&card.span, message)
                    .with_help("enforce the motion of a grid beside, joined by a stiff spring"));
            }
            let axes = &builder.nodes[node].axes;
            for component in &card.components {
                let (from, axis) = (3 * (usize::from(*component - 1) / 3), usize::from(*component - 1) % 3);
                for basic in 0..3 {
                    motions[6 * node + from + basic] += axes[(basic, axis)] * card.enforced;
                }
            }
            if card.components.is_empty() {
                motions[6 * node] += card.enforced;
            }
        }
    }
    Ok(Some(motions))
}

/// Grids that rigid elements and equations join.
fn tied(bulk: &BulkData) -> BTreeSet<u32> {
    let mut all = BTreeSet::new();
    for card in bulk.rigid.values() {
        all.insert(card.independent);
        all.extend(&card.dependent);
    }
    all.extend(bulk.rigid_bars.values().flat_map(|card| card.grids));
    for card in bulk.averages.values() {
        all.insert(card.reference);
        all.extend(card.groups.iter().flat_map(|group| &group.grids));
    }
    all.extend(bulk.equations.iter().flat_map(|card| card.terms.iter().map(|((grid, _), _)| *grid)));
    all
}
