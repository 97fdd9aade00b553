//! The deformed shape of the boxes, for pictures.

use crate::aircraft::assembly::Aircraft;
use crate::trim::model::Trimmed;
use nalgebra::Point3;

impl Aircraft {
    /// Corners of all boxes in the flow, deformed, seen from the centre, without the angle of attack.
    pub fn deformed(&self, trimmed: &Trimmed) -> Vec<[Point3<f64>; 4]> {
        let lattice = &self.flow.lattice;
        match &self.flow.supported {
            Some(held) => coupling::shape::deformed_boxes(lattice, held, &trimmed.displacement),
            None => lattice.boxes.iter().map(|panel| panel.corners).collect(),
        }
    }
}
