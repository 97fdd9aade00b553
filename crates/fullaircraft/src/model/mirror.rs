//! The left wing: bulk data mirrored about the plane y = 0, and which box is the image of which.
//!
//! Panels still run from left to right, so normals stay up and the strips of an image count the other way round:
//! the image of a box does not stand at its original's place in the list. Everything that belongs to boxes
//! (camber, corrections, box lists) goes by [`Image::boxes`], never by position.

use aero::Lattice;
use nalgebra::Point3;
use nastran::{BulkData, InputError};
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
    /// The mirror image of a model about y = 0, every number kept ([`BulkData::mirrored`]).
    ///
    /// # Errors
    /// If a card has no image, a panel cannot be divided into boxes, or a reference leads nowhere; the card is blamed.
    pub fn of(bulk: &BulkData) -> Result<Self, InputError> {
        let boxes = box_images(bulk, &Lattice::from_bulk(bulk)?);
        Ok(Self { bulk: bulk.mirrored(&boxes)?, boxes })
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
                    (Point3::new(corner.x, -corner.y, corner.z) - other).norm() < SAME_POINT_M
                });
                if same { Ok(at) } else { Err(fault("is not where its mirror image should be")) }
            })
            .collect()
    }
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
