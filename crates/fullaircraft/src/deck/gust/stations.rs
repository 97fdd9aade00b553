//! Monitoring stations of a deck in motion: MONPNT1 of boxes (air alone), MONPNT1 of grids and MONPNT3 (air less mass times
//! acceleration).

use crate::deck::modal::ModalDeck;
use crate::deck::monitors::monitors;
use crate::deck::net_monitors::{loaded_grids, motions};
use aero::StreamAxes;
use faer::Mat;
use nastran::{BulkData, ComponentOf, Frames, InputError, MonitorPoint};

/// A monitoring station.
#[derive(Debug, Clone)]
pub(crate) struct Station {
    /// Its name.
    pub(crate) name: String,
    /// Its label.
    pub(crate) label: String,
    /// Whether it adds up the loads of grids, with inertia; else of boxes.
    pub(crate) is_structural: bool,
    /// Component digits that it shows.
    pub(crate) axes: Vec<u8>,
    /// Six loads by loads of the boxes (two columns a box).
    pub(crate) rows: Mat<f64>,
    /// Six forces that accelerate its part, by accelerations of the modes.
    pub(crate) inertia: Mat<f64>,
}

/// The stations of a deck, and the names of those that are left out: of groups, which are no cards, of grids and boxes together, or of
/// components that are not there.
///
/// # Errors
/// If a component, list, box, grid or system is not there.
pub(crate) fn stations(deck: &ModalDeck) -> Result<(Vec<Station>, Vec<String>), InputError> {
    let bulk = &deck.bulk;
    let frames = Frames::resolve(bulk)?;
    let stream = StreamAxes::of_deck(&frames, deck.aero.acsid, &deck.aero.span)?;
    let modes = deck.omega_rad_s.len();
    let (of_boxes, _) = monitors(bulk, &deck.lattice, &frames)?;
    let mut all = Vec::new();
    let mut left_out = Vec::new();
    for (card, name) in bulk.monitors.iter().zip(bulk.station_names()) {
        let station = |is_structural: bool, rows: Mat<f64>, inertia: Mat<f64>| Station {
            name: name.clone(),
            label: card.label.clone(),
            is_structural,
            axes: card.axes.clone(),
            rows,
            inertia,
        };
        if let Some(monitor) = of_boxes.iter().find(|monitor| !card.is_structural && monitor.name == name) {
            let rows = monitor.seen_in(&stream).rows(&deck.lattice);
            all.push(station(false, rows, Mat::zeros(6, modes)));
        } else if let Some(grids) = grids(bulk, card) {
            let moved = motions(card, &grids, &frames, &deck.system)?;
            let rows = deck.spline.displace(moved.as_ref()).transpose().to_owned();
            let inertia = moved.transpose() * deck.system.inertia_loads(deck.shapes.as_ref());
            all.push(station(true, rows, inertia));
        } else {
            left_out.push(name);
        }
    }
    Ok((all, left_out))
}

/// The grids of a station: of the SET1 of a MONPNT3, or of those that the AECOMP of a MONPNT1 lists.
fn grids(bulk: &BulkData, card: &MonitorPoint) -> Option<Vec<u32>> {
    let of = |id: &u32| bulk.sets.get(id).map(|set| set.ids.clone());
    if card.is_structural {
        return card.set.parse().ok().and_then(|id: u32| of(&id)).and_then(|ids| loaded_grids(bulk, &ids));
    }
    let components = bulk.components_of(&card.set)?;
    if components.iter().any(|component| component.of != ComponentOf::Grids) {
        return None;
    }
    let lists: Option<Vec<Vec<u32>>> =
        components.iter().flat_map(|component| &component.lists).map(of).collect();
    let mut ids = lists?.concat();
    ids.sort_unstable();
    ids.dedup();
    Some(ids)
}
