//! The left wing: bulk data mirrored about the plane y = 0, and which box is the image of which.
//!
//! Panels still run from left to right, so normals stay up and the strips of an image count the other way round:
//! the image of a box does not stand at its original's place in the list. Everything that belongs to boxes
//! (camber, corrections, box lists) goes by [`Image::boxes`], never by position.
//!
//! Mirroring a point changes the sign of y. It also turns right-handed axes into left-handed ones; what a
//! deck says in local axes changes accordingly: the products of inertia xy and yz, and of a beam's section what
//! lies along its z axis (`I12`, z offsets), because element z is the cross product of axis and orientation vector.

use crate::model::mirror_elements;
use aero::Lattice;
use nalgebra::Point3;
use nastran::{
    Aefact, BeamElement, BulkData, Caero1, Conm2, Coord, CoordDefinition, Divisions, Frames, Grid,
    InputError, Orientation,
};
use std::collections::BTreeMap;

/// A mirrored model with the same numbers as its original.
#[derive(Debug, Clone, PartialEq)]
pub struct Image {
    /// The mirrored cards.
    pub bulk: BulkData,
    /// Number of the image for each box number of the original: one to one.
    pub boxes: BTreeMap<u32, u32>,
}

/// Corner coordinates that differ by less than this are the same, m.
const SAME_POINT_M: f64 = 1e-9;

impl Image {
    /// The mirror image of a model about y = 0, every number kept. Mirrored twice, a model in basic axes is
    /// itself again. Matrices other than `W2GJ`, and monitor points, are not mirrored but left out.
    ///
    /// # Errors
    /// If a grid's displacement system or a mass's system is not basic, an AEFACT divides both span and chord, or
    /// a reference leads nowhere; the card is blamed.
    pub fn of(bulk: &BulkData) -> Result<Self, InputError> {
        let frames = Frames::resolve(bulk)?;
        let mut image = BulkData {
            materials: bulk.materials.clone(),
            rigid: bulk.rigid.clone(),
            constraints: bulk.constraints.clone(),
            panel_properties: bulk.panel_properties.clone(),
            factors: bulk.factors.clone(),
            surfaces: bulk.surfaces.clone(),
            sets: bulk.sets.clone(),
            unknown: bulk.unknown.clone(),
            ..BulkData::default()
        };
        mirror_elements::add(bulk, &mut image)?;
        for grid in bulk.grids.values() {
            image.grids.insert(grid.id, mirrored_grid(grid, &frames)?);
        }
        for coord in bulk.coords.values() {
            image.coords.insert(coord.id, mirrored_coord(coord, &frames)?);
        }
        for mass in bulk.masses.values() {
            image.masses.insert(mass.id, mirrored_mass(mass)?);
        }
        for panel in bulk.panels.values() {
            image.panels.insert(panel.id, mirrored_panel(panel, &frames)?);
        }
        image.beams = bulk.beams.iter().map(|(id, beam)| (*id, mirrored_beam(beam))).collect();
        image.beam_properties = bulk.beam_properties.clone();
        for property in image.beam_properties.values_mut() {
            property.stations.iter_mut().for_each(|station| station.i12 = minus(station.i12));
            property
                .nsm_offset
                .iter_mut()
                .chain(&mut property.neutral_axis)
                .for_each(|at| at[1] = minus(at[1]));
        }
        reverse_strips(bulk, &mut image.factors)?;
        let boxes = box_images(bulk, &Lattice::from_bulk(bulk)?);
        image.box_lists = bulk.box_lists.clone();
        for list in image.box_lists.values_mut() {
            list.boxes = list.boxes.iter().map(|id| boxes.get(id).copied().unwrap_or(*id)).collect();
            list.boxes.sort_unstable();
        }
        if let Some(incidence) = bulk.matrices.get("W2GJ") {
            let mut carried = incidence.clone();
            for (column, original) in carried.columns.iter_mut().zip(&incidence.columns) {
                *column = carry(&boxes, original);
            }
            image.matrices.insert("W2GJ".to_owned(), carried);
        }
        Ok(Self { bulk: image, boxes })
    }

    /// Checks on the lattices themselves that every box has one image and every image one original, corner by
    /// corner; gives for each box of `original` the index of its image in `image`, whose numbers are `shift` higher.
    ///
    /// # Errors
    /// If a box has no image or an image is not where it should be.
    pub fn check(&self, original: &Lattice, image: &Lattice, shift: u32) -> Result<Vec<usize>, InputError> {
        let index: BTreeMap<u32, usize> = image.boxes.iter().enumerate().map(|(at, b)| (b.id, at)).collect();
        let mut taken = vec![false; image.len()];
        original
            .boxes
            .iter()
            .map(|panel| {
                let fault = |what: &str| InputError::general(format!("box {} {what}", panel.id));
                let id = self.boxes.get(&panel.id).ok_or_else(|| fault("has no mirror image"))?;
                let at =
                    *index.get(&(id + shift)).ok_or_else(|| fault("has a mirror image without a box"))?;
                if std::mem::replace(&mut taken[at], true) {
                    return Err(fault("shares its mirror image with another box"));
                }
                let [c1, c2, c3, c4] = &panel.corners;
                let same = [c4, c3, c2, c1].iter().zip(&image.boxes[at].corners).all(|(corner, other)| {
                    (Point3::new(corner.x, minus(corner.y), corner.z) - other).norm() < SAME_POINT_M
                });
                if same { Ok(at) } else { Err(fault("is not where its mirror image should be")) }
            })
            .collect()
    }
}

/// Values in ascending box number, carried to the images: also in ascending number.
fn carry(boxes: &BTreeMap<u32, u32>, values: &[f64]) -> Vec<f64> {
    let mut carried: Vec<(u32, f64)> = boxes.values().copied().zip(values.iter().copied()).collect();
    carried.sort_unstable_by_key(|(id, _)| *id);
    carried.into_iter().map(|(_, value)| value).collect()
}

/// The same row of the strip that counts from the other side.
fn box_images(bulk: &BulkData, lattice: &Lattice) -> BTreeMap<u32, u32> {
    let mut boxes = BTreeMap::new();
    for surface in lattice.surfaces.iter().filter(|surface| bulk.panels.contains_key(&surface.id)) {
        let id =
            |strip: usize, row: usize| lattice.boxes[surface.first_box + strip * surface.chordwise + row].id;
        for strip in 0..surface.spanwise {
            for row in 0..surface.chordwise {
                boxes.insert(id(strip, row), id(surface.spanwise - 1 - strip, row));
            }
        }
    }
    boxes
}

/// AEFACT of strips count from the other side.
fn reverse_strips(bulk: &BulkData, factors: &mut BTreeMap<u32, Aefact>) -> Result<(), InputError> {
    let mut strips = Vec::new();
    for panel in bulk.panels.values() {
        if let Divisions::Aefact(id) = panel.span_divisions {
            strips.push(id);
        }
    }
    for panel in bulk.panels.values() {
        if let Divisions::Aefact(id) = panel.chord_divisions
            && strips.contains(&id)
        {
            let message = format!("AEFACT {id} divides chord and span, so it cannot be mirrored");
            return Err(
                InputError::at(&panel.span, message).with_help("give chord and span their own AEFACT")
            );
        }
    }
    for list in factors.values_mut().filter(|list| strips.contains(&list.id)) {
        list.values = list.values.iter().rev().map(|fraction| 1.0 - fraction).collect();
    }
    Ok(())
}

fn mirrored_grid(grid: &Grid, frames: &Frames) -> Result<Grid, InputError> {
    if grid.cd != 0 {
        let message =
            format!("GRID {} has displacement system {}, so it cannot be mirrored", grid.id, grid.cd);
        return Err(InputError::at(&grid.span, message).with_help("set field CD of the wing's grids to 0"));
    }
    Ok(Grid { cp: 0, xyz: flipped(frames.grid_point(grid)?.into()), ..grid.clone() })
}

fn mirrored_coord(coord: &Coord, frames: &Frames) -> Result<Coord, InputError> {
    let definition = match &coord.definition {
        CoordDefinition::Points { rid, a, b, c } => {
            let flip = |xyz: &[f64; 3]| Ok(flipped(frames.point(*rid, *xyz, &coord.span)?.into()));
            CoordDefinition::Points { rid: 0, a: flip(a)?, b: flip(b)?, c: flip(c)? }
        }
        CoordDefinition::Grids(grids) => CoordDefinition::Grids(*grids),
    };
    Ok(Coord { definition, ..coord.clone() })
}

fn mirrored_mass(mass: &Conm2) -> Result<Conm2, InputError> {
    if mass.cid > 0 {
        let message =
            format!("CONM2 {} has coordinate system {}, so it cannot be mirrored", mass.id, mass.cid);
        return Err(InputError::at(&mass.span, message).with_help("set field CID of the wing's masses to 0"));
    }
    let [i11, i21, i22, i31, i32, i33] = mass.inertia;
    let inertia = [i11, minus(i21), i22, i31, minus(i32), i33];
    Ok(Conm2 { offset: flipped(mass.offset), inertia, ..mass.clone() })
}

fn mirrored_panel(panel: &Caero1, frames: &Frames) -> Result<Caero1, InputError> {
    let flip = |xyz: [f64; 3]| Ok(flipped(frames.point(panel.cp, xyz, &panel.span)?.into()));
    Ok(Caero1 {
        cp: 0,
        point_1: flip(panel.point_4)?,
        chord_1: panel.chord_4,
        point_4: flip(panel.point_1)?,
        chord_4: panel.chord_1,
        ..panel.clone()
    })
}

fn mirrored_beam(beam: &BeamElement) -> BeamElement {
    let orientation = match beam.orientation {
        Orientation::Vector(vector) => Orientation::Vector(flipped(vector)),
        Orientation::Grid(grid) => Orientation::Grid(grid),
    };
    BeamElement { orientation, offsets: beam.offsets.map(flipped), ..beam.clone() }
}

fn flipped([x, y, z]: [f64; 3]) -> [f64; 3] {
    [x, minus(y), z]
}

/// Minus, without a negative zero.
fn minus(value: f64) -> f64 {
    0.0 - value
}
