//! MONPNT1: air loads of a component's boxes, added up about a point.

use aero::{BoxLoads, Lattice, StreamAxes};
use faer::Mat;
use nalgebra::{Matrix3, Point3};
use nastran::{Aecomp, BulkData, ComponentOf, Frames, InputError};

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
    /// It in the axes of the stream, for boxes that are given there.
    pub(crate) fn seen_in(&self, stream: &StreamAxes) -> Self {
        Self {
            point: stream.seen(&self.point),
            axes: stream.axes.transpose() * self.axes,
            name: self.name.clone(),
            boxes: self.boxes.clone(),
        }
    }

    /// Three forces and three moments (rows) by the loads of the boxes (two columns a box).
    pub(crate) fn rows(&self, lattice: &Lattice) -> Mat<f64> {
        let mut rows = Mat::zeros(6, 2 * lattice.len());
        for &place in &self.boxes {
            for part in [2 * place, 2 * place + 1] {
                let mut unit = BoxLoads { values: vec![0.0; 2 * lattice.len()] };
                unit.values[part] = 1.0;
                let (force, moment) = unit.resultant(lattice, std::iter::once(place), &self.point);
                let turned = [self.axes.transpose() * force, self.axes.transpose() * moment];
                (0..6).for_each(|row| rows[(row, part)] = turned[row / 3][row % 3]);
            }
        }
        rows
    }

    /// Three forces and three moments.
    pub(crate) fn loads(&self, lattice: &Lattice, loads: &BoxLoads) -> [f64; 6] {
        let (force, moment) = loads.resultant(lattice, self.boxes.iter().copied(), &self.point);
        let turned = [self.axes.transpose() * force, self.axes.transpose() * moment];
        std::array::from_fn(|i| turned[i / 3][i % 3])
    }
}

/// The MONPNT1 of a deck, and the names of those that are left out: of components made of grids, or that are not there, which
/// Nastran leaves out as well.
///
/// # Errors
/// If a list, box or system is not there.
pub(crate) fn monitors(
    bulk: &BulkData,
    lattice: &Lattice,
    frames: &Frames,
) -> Result<(Vec<Monitor>, Vec<String>), InputError> {
    let (mut all, mut skipped) = (Vec::new(), Vec::new());
    for (card, name) in bulk.monitors.iter().zip(bulk.station_names()) {
        if card.is_structural {
            continue;
        }
        let axes = frames.axes_at(card.cd, &card.span)?;
        let point = frames.point(card.cp, card.xyz, &card.span)?;
        let components = bulk.components_of(&card.set).unwrap_or_default();
        if components.is_empty() || components.iter().any(|component| component.of == ComponentOf::Grids) {
            skipped.push(name);
            continue;
        }
        let boxes = boxes(bulk, &components, lattice).map_err(|why| InputError::at(&card.span, why))?;
        all.push(Monitor { name, boxes, point, axes });
    }
    Ok((all, skipped))
}

fn boxes(bulk: &BulkData, components: &[&Aecomp], lattice: &Lattice) -> Result<Vec<usize>, String> {
    let mut places = Vec::new();
    for (component, list) in
        components.iter().flat_map(|component| component.lists.iter().map(move |list| (component, list)))
    {
        let name = &component.name;
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
