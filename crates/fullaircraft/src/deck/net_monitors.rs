//! MONPNT3: net loads (the air's, where the splines put them, less mass times acceleration) on a set of grids, added up about a point.
//!
//! ```text
//! F = Rᵀ (q Gᵀ P - M a)      R: the motions of the set's grids along and about the station's axes, all other grids still
//! ```
//! Grids that are held in all six components, and nothing beside them, are a wind tunnel's balance: what the whole deck puts on it.
//! What acts on the part, in the right-hand axes of CD: on a clamped wing, what the wing puts on its root.

use crate::deck::structure::reference_motions;
use faer::{Mat, MatRef};
use nastran::{BulkData, Frames, InputError, MonitorPoint};
use std::collections::BTreeSet;
use structure::System;

/// A monitoring station of the structure.
#[derive(Debug, Clone)]
pub(crate) struct NetMonitor {
    /// Its name.
    pub(crate) name: String,
    /// Six loads by loads on the s-set.
    by_air: Mat<f64>,
    /// Six loads by the accelerations of the variables: force to accelerate its part.
    by_variables: Mat<f64>,
}

impl NetMonitor {
    /// Three forces and three moments of loads on the s-set with the values of the variables.
    pub(crate) fn loads(&self, air: &[f64], values: &[f64]) -> [f64; 6] {
        let row = |of: &Mat<f64>, i: usize, by: &[f64]| -> f64 {
            by.iter().enumerate().map(|(j, value)| of[(i, j)] * value).sum()
        };
        std::array::from_fn(|i| row(&self.by_air, i, air) - row(&self.by_variables, i, values))
    }
}

/// The MONPNT3 of a deck whose GRIDSET is a SET1, and the names of the others (groups are no cards; held grids beside other held ones). ELEMSET and XFLAG are not
/// read: all loads of the grids count. `mass_times` is mass times the accelerations of the variables, g-set by variables.
///
/// # Errors
/// If a grid or a system is not there.
pub(crate) fn net_monitors(
    bulk: &BulkData,
    frames: &Frames,
    free: &System,
    s_dofs: &[usize],
    mass_times: MatRef<'_, f64>,
) -> Result<(Vec<NetMonitor>, Vec<String>), InputError> {
    let (mut all, mut skipped) = (Vec::new(), Vec::new());
    let stations = bulk.monitors.iter().zip(bulk.station_names());
    for (card, name) in stations.filter(|(card, _)| card.is_structural) {
        let set = card.set.parse::<u32>().ok().and_then(|id| bulk.sets.get(&id));
        let Some(set) = set else {
            skipped.push(name);
            continue;
        };
        let Some(grids) = loaded_grids(bulk, &set.ids) else {
            skipped.push(name);
            continue;
        };
        let motions = motions(card, &grids, frames, free)?;
        all.push(NetMonitor {
            name,
            by_air: coupling::supported::restrict(motions.as_ref(), s_dofs).transpose().to_owned(),
            by_variables: motions.transpose() * mass_times,
        });
    }
    Ok((all, skipped))
}

/// The grids whose net loads a station of these adds up: their own, or, where a wind tunnel's balance holds all of them in all six
/// components, those of the whole deck, which it feels as a reaction; none if something else is held beside them.
pub(crate) fn loaded_grids(bulk: &BulkData, ids: &[u32]) -> Option<Vec<u32>> {
    let is_held = |id: &u32| {
        let of = bulk.constraints.iter().filter(|card| card.grids.contains(id));
        let components: BTreeSet<u8> = of.flat_map(|card| card.components.iter().copied()).collect();
        components.len() == 6
    };
    if ids.is_empty() || !ids.iter().all(is_held) {
        return Some(ids.to_vec());
    }
    let alone = bulk.constraints.iter().flat_map(|card| &card.grids).all(|id| ids.contains(id));
    (alone && bulk.supports.is_empty()).then(|| bulk.grids.keys().copied().collect())
}

/// Motions of a station's grids along and about its axes, g-set by 6.
pub(crate) fn motions(
    card: &MonitorPoint,
    grids: &[u32],
    frames: &Frames,
    free: &System,
) -> Result<Mat<f64>, InputError> {
    let axes = frames.axes_at(card.cd, &card.span)?;
    let point = frames.point(card.cp, card.xyz, &card.span)?;
    let all = reference_motions(free, &point, &axes);
    let mut own = Mat::zeros(all.nrows(), 6);
    for grid in grids {
        let node = free.node_index(*grid).ok_or_else(|| {
            InputError::at(&card.span, format!("GRID {grid} of MONPNT3 {} is not there", card.name))
        })?;
        for dof in 6 * node..6 * node + 6 {
            (0..6).for_each(|motion| own[(dof, motion)] = all[(dof, motion)]);
        }
    }
    Ok(own)
}
