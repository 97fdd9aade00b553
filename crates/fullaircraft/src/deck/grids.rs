//! A deck's structure as loads at its grids need it: points, mass, SUPORT, stations of MONPNT3. All is in the deck's units and the basic
//! system.

use crate::deck::net_monitors::loaded_grids;
use crate::deck::structure::carried;
use crate::package::rows::Balanced;
use crate::stations::places::Station;
use faer::Mat;
use nalgebra::Point3;
use nastran::{BulkData, Frames, InputError};
use structure::System;

/// A deck's structure as loads at its grids need it.
#[derive(Debug)]
pub struct DeckGrids {
    /// The structure under the deck's constraints.
    pub free: System,
    /// The same, held at the SUPORT motions, too.
    pub held: System,
    /// Grid and components (1 to 6) of the SUPORT.
    pub support: Option<(u32, Vec<u8>)>,
    /// What no constraint carries: the work of all loads in each motion of the SUPORT, which leaves clamps where they are.
    pub balanced: Vec<Balanced>,
    /// Places in the g-set of the loads that the air's splines reach.
    pub(crate) s_dofs: Vec<usize>,
    /// Mass times the acceleration of each variable, g-set by variables.
    pub(crate) mass_times: Mat<f64>,
    /// The whole deck's mass as its plunge carries it, without what AUTOSPC holds, in the deck's unit; of a half model, that half's.
    pub mass: f64,
}

impl DeckGrids {
    /// Of a deck's structure, free and held; `motions` are those of the SUPORT, g-set by components in the order of the cards.
    ///
    /// # Errors
    /// If the displacement system of a grid is not there.
    pub(crate) fn new(
        bulk: &BulkData,
        [free, held]: [System; 2],
        s_dofs: Vec<usize>,
        [motions, mass_times]: [Mat<f64>; 2],
    ) -> Result<Self, InputError> {
        let balanced = balanced(bulk, &free, &motions);
        let up = carried(bulk, &free, &free.rigid_body(&Point3::origin()).subcols(2, 1).to_owned())?;
        let moved = free.inertia_loads(up.as_ref());
        let mass = (0..up.nrows()).map(|dof| up[(dof, 0)] * moved[(dof, 0)]).sum();
        Ok(Self { support: support_of(bulk), balanced, free, held, s_dofs, mass_times, mass })
    }

    /// The MONPNT3 of a deck whose GRIDSET is a SET1.
    ///
    /// # Errors
    /// If a grid or a system is not there.
    pub fn monitored(&self, bulk: &BulkData) -> Result<Vec<Station>, InputError> {
        let frames = Frames::resolve(bulk)?;
        let mut all = Vec::new();
        let stations = bulk.monitors.iter().zip(bulk.station_names());
        for (card, name) in stations.filter(|(card, _)| card.is_structural) {
            let set = card.set.parse::<u32>().ok().and_then(|id| bulk.sets.get(&id));
            let Some(ids) = set.and_then(|set| loaded_grids(bulk, &set.ids)) else { continue };
            let node = |grid: &u32| {
                self.free.node_index(*grid).ok_or_else(|| {
                    InputError::at(&card.span, format!("GRID {grid} of MONPNT3 {} is not there", card.name))
                })
            };
            let mut nodes = ids.iter().map(node).collect::<Result<Vec<_>, _>>()?;
            nodes.sort_unstable();
            nodes.dedup();
            all.push(Station {
                channel: name.clone(),
                name,
                point: frames.point(card.cp, card.xyz, &card.span)?,
                nodes,
                axes: frames.axes_at(card.cd, &card.span)?,
            });
        }
        Ok(all)
    }
}

/// The motions of a deck's SUPORT as those of the first grid that it names.
fn balanced(bulk: &BulkData, free: &System, motions: &Mat<f64>) -> Vec<Balanced> {
    let first = bulk.supports.first().and_then(|support| free.node_index(support.grid));
    let Some(node) = first else { return Vec::new() };
    let components = bulk.supports.iter().flat_map(|support| &support.components);
    let one = |(at, component): (usize, &u8)| Balanced {
        load: usize::from(*component) - 1,
        about: free.points()[node],
        shares: std::array::from_fn(|of| motions[(6 * node + of, at)]),
    };
    components.enumerate().map(one).collect()
}

/// Grid and components of a deck's SUPORT.
fn support_of(bulk: &BulkData) -> Option<(u32, Vec<u8>)> {
    let grid = bulk.supports.first()?.grid;
    let mut components: Vec<u8> =
        bulk.supports.iter().flat_map(|one| one.components.iter().copied()).collect();
    components.sort_unstable();
    Some((grid, components))
}
