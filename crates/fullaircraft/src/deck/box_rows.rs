//! What every spline of a deck takes and gives: the grids of its set, and rows of a box.

use nastran::{BulkData, InputError, SplineCard};

/// The grids of a spline's set as places of nodes.
pub(crate) fn nodes(bulk: &BulkData, card: &SplineCard, ids: &[u32]) -> Result<Vec<usize>, InputError> {
    let blame = |message: String| InputError::at(&card.span, message);
    let set = bulk.sets.get(&card.set).ok_or_else(|| blame(format!("SET1 {} is not there", card.set)))?;
    let node = |id: &u32| {
        ids.binary_search(id).map_err(|_| blame(format!("GRID {id} of SET1 {} is not there", set.id)))
    };
    set.ids.iter().map(node).collect()
}

/// Heave and pitch of a box by degrees of freedom of the g-set.
pub(crate) type BoxRows = [Vec<(usize, f64)>; 2];
