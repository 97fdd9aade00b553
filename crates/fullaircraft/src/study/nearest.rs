//! Boxes that follow their nearest grid as on a rigid arm: a beam spline (SPLINE5) of one grid whose rotations are attached too.

use super::cards::card;
use aero::{Lattice, StreamAxes};
use nalgebra::Point3;
use nastran::{BulkData, Frames, Grid, InputError, Span};
use std::collections::BTreeMap;

/// Cosine between a panel's normal and y beyond which the axis of its splines is z: a beam spline's axis lies in the panel.
const UPRIGHT: f64 = 0.7;

/// Share by which distances of grids that are as near may differ.
const ALIKE: f64 = 1e-9;

/// The cards, by number from `first` on, with `upright` as the number of the system of upright panels; `acsid` is that of the stream.
///
/// # Errors
/// If there are no boxes or no grids, or a set is not there.
pub(super) fn cards(
    bulk: &BulkData,
    sets: Option<&[u32]>,
    [first, upright]: [u32; 2],
    acsid: u32,
) -> Result<String, InputError> {
    let frames = Frames::resolve(bulk)?;
    let stream = StreamAxes::of_deck(&frames, acsid, &Span::generated("the study"))?;
    let lattice = Lattice::in_axes(bulk, &stream)?;
    let grids = grids(bulk, sets, &|grid| Ok(stream.seen(&frames.grid_point(grid)?)))?;
    if grids.is_empty() || lattice.is_empty() {
        return Err(InputError::general("the decks have no boxes or no grids that could be joined"));
    }
    let mut groups: BTreeMap<(u32, u32), (Vec<u32>, bool)> = BTreeMap::new();
    for surface in &lattice.surfaces {
        let end = surface.first_box + surface.chordwise * surface.spanwise;
        for one in &lattice.boxes[surface.first_box..end] {
            let middle = one.mid_point();
            let Some(grid) = nearest(&grids, &middle) else { continue };
            let is_upright = one.normal().y.abs() > UPRIGHT;
            groups.entry((surface.id, grid)).or_insert((Vec::new(), is_upright)).0.push(one.id);
        }
    }
    let axes = ["0.", "0.", "0.", "0.", "-1.", "0.", "1.", "0.", "0."].map(str::to_owned);
    let mut text = card("CORD2R", &[&[upright, acsid].map(|id| id.to_string())[..], &axes].concat());
    for (number, ((panel, grid), (boxes, is_upright))) in (first..).zip(groups) {
        let id = number.to_string();
        text += &card("SET1", &[id.clone(), grid.to_string()]);
        let listed = std::iter::once(id.clone()).chain(boxes.iter().map(ToString::to_string));
        text += &card("AELIST", &listed.collect::<Vec<_>>());
        let system = if is_upright { upright } else { acsid }.to_string();
        let [blank, rigid] = [String::new(), "0.".to_owned()];
        text += &card(
            "SPLINE5",
            &[
                id.clone(),
                panel.to_string(),
                id.clone(),
                blank,
                id,
                rigid.clone(),
                "1.".to_owned(),
                system,
                rigid.clone(),
                rigid,
            ],
        );
    }
    Ok(text)
}

/// The nearest grid; of several as near, which rounding must not choose among, that with the lowest number.
fn nearest(grids: &[(u32, Point3<f64>)], point: &Point3<f64>) -> Option<u32> {
    let far = |grid: &(u32, Point3<f64>)| (grid.1 - point).norm();
    let least = grids.iter().map(far).fold(f64::INFINITY, f64::min);
    grids.iter().find(|grid| far(grid) <= least * (1.0 + ALIKE)).map(|(id, _)| *id)
}

/// Numbers and places of the grids that boxes may follow, by rising numbers.
fn grids(
    bulk: &BulkData,
    sets: Option<&[u32]>,
    place: &dyn Fn(&Grid) -> Result<Point3<f64>, InputError>,
) -> Result<Vec<(u32, Point3<f64>)>, InputError> {
    let mut wanted = Vec::new();
    for id in sets.unwrap_or_default() {
        let set = bulk.sets.get(id);
        wanted.extend(
            set.ok_or_else(|| InputError::general(format!("SET1 {id} is not there")))?.ids.iter().copied(),
        );
    }
    let is_wanted = |id: u32| sets.is_none() || wanted.contains(&id);
    let all = bulk.grids.values().filter(|grid| is_wanted(grid.id));
    all.map(|grid| Ok((grid.id, place(grid)?))).collect()
}
