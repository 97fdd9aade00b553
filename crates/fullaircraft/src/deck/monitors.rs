//! MONPNT1: air loads of a component's boxes, added up about a point.

use aero::{Integration, Lattice};
use nalgebra::{Matrix3, Vector3};
use nastran::{BulkData, ComponentOf, Frames, InputError};

/// A monitoring station: loads per pressure coefficient and dynamic pressure.
#[derive(Debug, Clone)]
pub(crate) struct Monitor {
    /// Its name.
    pub(crate) name: String,
    /// Box, and its force and moment about the point in the station's axes: of its lift (per area), and of its moment about
    /// its own midpoint (per area and arm).
    parts: Vec<(usize, [[f64; 6]; 2])>,
}

impl Monitor {
    /// Three forces and three moments.
    ///
    /// `acting` gives for each box the pressure coefficients that make its lift and its moment.
    pub(crate) fn loads(&self, q: f64, acting: &[[f64; 2]]) -> [f64; 6] {
        let mut sums = [0.0; 6];
        for (place, units) in &self.parts {
            for (cp, unit) in acting[*place].iter().zip(units) {
                sums.iter_mut().zip(unit).for_each(|(sum, unit)| *sum += q * cp * unit);
            }
        }
        sums
    }
}

/// The MONPNT1 of a deck, and the names of the stations that are left out: MONPNT3, whose loads are the structure's, and MONPNT1
/// of a component made of grids.
///
/// # Errors
/// If a component, list, box or system is not there.
pub(crate) fn monitors(
    bulk: &BulkData,
    lattice: &Lattice,
    frames: &Frames,
    integration: &Integration,
) -> Result<(Vec<Monitor>, Vec<String>), InputError> {
    let (mut all, mut skipped) = (Vec::new(), Vec::new());
    for card in &bulk.monitors {
        if card.is_structural {
            skipped.push(card.name.clone());
            continue;
        }
        let axes: Matrix3<f64> = frames.axes_at(card.cd, &card.span)?;
        let point = frames.point(card.cp, card.xyz, &card.span)?;
        let part = |place: usize| {
            let panel = &lattice.boxes[place];
            let force = panel.normal() * integration.area(place);
            let moment = (panel.mid_point() - point).cross(&force);
            let own = panel.pitch_axis() * integration.area(place) * integration.moment_arm(place);
            let turned = |force: Vector3<f64>, moment: Vector3<f64>| {
                let turned = [axes.transpose() * force, axes.transpose() * moment];
                std::array::from_fn(|i| turned[i / 3][i % 3])
            };
            (place, [turned(force, moment), turned(Vector3::zeros(), own)])
        };
        if bulk.aero_components.get(&card.set).is_some_and(|component| component.of == ComponentOf::Grids) {
            skipped.push(card.name.clone());
            continue;
        }
        let boxes = boxes(bulk, &card.set, lattice).map_err(|why| InputError::at(&card.span, why))?;
        all.push(Monitor { name: card.name.clone(), parts: boxes.into_iter().map(part).collect() });
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
