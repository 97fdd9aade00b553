//! The plane of symmetry y = const, as a boundary condition and as an explicit mirror image.

use crate::error::AeroError;
use crate::geometry::AeroBox;
use crate::lattice::{Lattice, Surface};
use nalgebra::Point3;
use serde::{Deserialize, Serialize};

/// Whether the lattice has an image on the other side of a plane y = `y_m`.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub enum MirrorPlane {
    /// No image.
    None,
    /// The image carries the mirrored load: a wall, or the other half in symmetric flow.
    Symmetric {
        /// Place of the plane, m.
        y_m: f64,
    },
    /// The image carries the opposite of the mirrored load: the other half in roll or sideslip.
    Antisymmetric {
        /// Place of the plane, m.
        y_m: f64,
    },
}

impl MirrorPlane {
    /// Place of the plane and the factor of the image's circulation (+1 or -1), if there is an image.
    pub(crate) fn image(self) -> Option<(f64, f64)> {
        match self {
            Self::None => None,
            Self::Symmetric { y_m } => Some((y_m, 1.0)),
            Self::Antisymmetric { y_m } => Some((y_m, -1.0)),
        }
    }

    /// Refuses boxes that cross the plane or stand on both sides of it. A fin in the plane is its own image: in symmetric flow it carries
    /// nothing, in antisymmetric flow it and its image half of the load each.
    ///
    /// A box may overlap the plane by a millionth of its size, which is what rounded decks need.
    ///
    /// # Errors
    /// Names the first such box.
    pub fn check(self, lattice: &Lattice) -> Result<(), AeroError> {
        let Some((y_m, _)) = self.image() else { return Ok(()) };
        let mut first: Option<(u32, f64)> = None;
        for panel in &lattice.boxes {
            let Some(side) = side_of_plane(panel, y_m)? else { continue };
            let id = panel.id;
            match first {
                None => first = Some((id, side)),
                Some((other, there)) if there != side => return Err(AeroError::BothSides { id, other, y_m }),
                Some(_) => {}
            }
        }
        Ok(())
    }

    /// Refuses boxes in the plane.
    ///
    /// # Errors
    /// Names the first such box.
    pub fn refuse_within(self, lattice: &Lattice) -> Result<(), AeroError> {
        let Some((y_m, _)) = self.image() else { return Ok(()) };
        let within = lattice.boxes.iter().find(|panel| matches!(side_of_plane(panel, y_m), Ok(None)));
        within.map_or(Ok(()), |panel| Err(AeroError::InPlane { id: panel.id, y_m }))
    }

    /// Places of the boxes that carry nothing: those in a plane of symmetric flow.
    pub(crate) fn silent(self, lattice: &Lattice) -> Vec<usize> {
        let Self::Symmetric { y_m } = self else { return Vec::new() };
        let is_within = |at: &usize| matches!(side_of_plane(&lattice.boxes[*at], y_m), Ok(None));
        (0..lattice.len()).filter(is_within).collect()
    }
}

/// Takes boxes out of an influence matrix: each needs the incidence that it has a pressure.
pub(crate) fn silence<T: faer::traits::ComplexField>(matrix: &mut faer::Mat<T>, silent: &[usize]) {
    for box_ in silent {
        matrix.row_mut(*box_).fill(T::zero_impl());
        matrix.col_mut(*box_).fill(T::zero_impl());
        matrix[(*box_, *box_)] = T::one_impl();
    }
}

/// +1 or -1: on which side of the plane the box lies; nothing of one in it.
fn side_of_plane(panel: &AeroBox, y_m: f64) -> Result<Option<f64>, AeroError> {
    let tolerance = 1e-6 * panel.area_m2().sqrt();
    let (low, high) = panel.corners.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), corner| {
        (low.min(corner.y - y_m), high.max(corner.y - y_m))
    });
    match (low < -tolerance, high > tolerance) {
        (true, true) => Err(AeroError::CrossesPlane { id: panel.id, y_m }),
        (false, false) => Ok(None),
        (true, false) => Ok(Some(-1.0)),
        (false, true) => Ok(Some(1.0)),
    }
}

/// Which box of the original each box of a mirror image is: one to one.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct BoxMap {
    /// Index in the original lattice, one entry for each box of the image.
    pub original: Vec<usize>,
}

impl BoxMap {
    /// A per-box quantity of the original, in the image's order.
    ///
    /// # Panics
    /// If `values` is shorter than the original lattice has boxes.
    #[must_use]
    pub fn carry<T: Clone>(&self, values: &[T]) -> Vec<T> {
        self.original.iter().map(|&index| values[index].clone()).collect()
    }
}

impl Lattice {
    /// The mirror image about y = `y_m`, alone, and which box came from which.
    ///
    /// Box order and numbers stay. Side 1 becomes side 2 and vice versa, so that a panel that ran from left to
    /// right still does and its normal stays up; in general the image's normal is the mirror image of the
    /// normal. Mirroring twice gives the lattice back.
    pub fn mirrored(&self, y_m: f64) -> (Self, BoxMap) {
        let flip = |point: &Point3<f64>| {
            // With the plane at zero this is exact, and for other planes exact where it can be.
            let y = if y_m == 0.0 { -point.y } else { 2.0 * y_m - point.y };
            Point3::new(point.x, y, point.z)
        };
        let boxes = self.boxes.iter().map(|panel| {
            let [c1, c2, c3, c4] = &panel.corners;
            AeroBox { id: panel.id, corners: [flip(c4), flip(c3), flip(c2), flip(c1)] }
        });
        let lattice = Self { boxes: boxes.collect(), surfaces: self.surfaces.clone() };
        (lattice, BoxMap { original: (0..self.len()).collect() })
    }

    /// The same lattice with `add` added to every box and panel number.
    ///
    /// # Errors
    /// If a number would become too large.
    pub fn renumbered(&self, add: u32) -> Result<Self, nastran::InputError> {
        let shift = |id: u32| {
            id.checked_add(add).ok_or_else(|| {
                nastran::InputError::general(format!(
                    "number {id} cannot be raised by {add}: it exceeds {}",
                    u32::MAX
                ))
            })
        };
        let boxes = self.boxes.iter().map(|b| Ok(AeroBox { id: shift(b.id)?, corners: b.corners }));
        let surfaces = self.surfaces.iter().map(|s| Ok(Surface { id: shift(s.id)?, ..s.clone() }));
        Ok(Self {
            boxes: boxes.collect::<Result<_, nastran::InputError>>()?,
            surfaces: surfaces.collect::<Result<_, nastran::InputError>>()?,
        })
    }
}
