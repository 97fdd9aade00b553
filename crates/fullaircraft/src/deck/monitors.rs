//! MONPNT1: air loads of a component's boxes, added up about a point.

use aero::{BoxLoads, Lattice};
use nalgebra::{Matrix3, Point3};
use nastran::{BulkData, ComponentOf, Frames, InputError};

/// A monitoring station.
#[derive(Debug, Clone)]
pub(crate) struct Monitor {
    /// Its name.
    pub(crate) name: String,
    /// Boxes whose loads it adds up.
    boxes: Vec<usize>,
    /// The point its moments are about.
    point: Point3<f64>,
    /// The axes it shows them in, as columns.
    axes: Matrix3<f64>,
}

impl Monitor {
    /// Three forces and three moments.
    pub(crate) fn loads(&self, lattice: &Lattice, loads: &BoxLoads) -> [f64; 6] {
        let (force, moment) = loads.resultant(lattice, self.boxes.iter().copied(), &self.point);
        let turned = [self.axes.transpose() * force, self.axes.transpose() * moment];
        std::array::from_fn(|i| turned[i / 3][i % 3])
    }
}

/// The MONPNT1 of a deck, and the names of those that are left out: of a component made of grids.
///
/// # Errors
/// If a component, list, box or system is not there.
pub(crate) fn monitors(
    bulk: &BulkData,
    lattice: &Lattice,
    frames: &Frames,
) -> Result<(Vec<Monitor>, Vec<String>), InputError> {
    let (mut all, mut skipped) = (Vec::new(), Vec::new());
    for card in &bulk.monitors {
        if card.is_structural {
            continue;
        }
        let axes = frames.axes_at(card.cd, &card.span)?;
        let point = frames.point(card.cp, card.xyz, &card.span)?;
        if bulk.aero_components.get(&card.set).is_some_and(|component| component.of == ComponentOf::Grids) {
            skipped.push(card.name.clone());
            continue;
        }
        let boxes = boxes(bulk, &card.set, lattice).map_err(|why| InputError::at(&card.span, why))?;
        all.push(Monitor { name: card.name.clone(), boxes, point, axes });
    }
    Ok((all, skipped))
}

fn boxes(bulk: &BulkData, name: &str, lattice: &Lattice) -> Result<Vec<usize>, String> {
    let component = bulk.aero_components.get(name).ok_or_else(|| format!("AECOMP {name} is not there"))?;
    let mut places = Vec::new();
    for list in &component.lists {
        match component.of {
            ComponentOf::Grids => {}
            ComponentOf::Panels => {
                let surface = lattice.surfaces.iter().find(|surface| surface.id == *list);
                let surface =
                    surface.ok_or_else(|| format!("CAERO1 {list} of AECOMP {name} is not there"))?;
                let count = surface.chordwise * surface.spanwise;
                places.extend(surface.first_box..surface.first_box + count);
            }
            ComponentOf::Boxes => {
                let list = bulk.box_lists.get(list).ok_or_else(|| format!("AELIST {list} is not there"))?;
                for id in &list.boxes {
                    places.push(
                        lattice
                            .index_of(*id)
                            .ok_or_else(|| format!("box {id} of AELIST {} is not there", list.id))?,
                    );
                }
            }
        }
    }
    places.sort_unstable();
    places.dedup();
    Ok(places)
}
