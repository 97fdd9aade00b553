//! Boxes where the structure has carried them.

use crate::spline::{feet_on_axis, nearest_nodes};
use crate::wing_file::SplineKind;
use aero::{AeroBox, Lattice, MirrorPlane, Seams};
use nalgebra::{Matrix3, Point3, Rotation3, Vector3};
use structure::nonlinear::{Carried, CarriedPoint, PlacedCarriers, State, differenced};

/// The boxes of a lattice and what they hang on.
#[derive(Debug, Clone)]
pub(super) struct CarriedBoxes {
    feet: Vec<CarriedPoint>,
    carried: Carried,
    nodes: usize,
    /// Where they meet.
    pub(super) seams: Seams,
}

/// Boxes in a row of a lattice and what they follow.
#[derive(Debug, Clone)]
pub struct CarriedPart {
    /// The first box and the one after the last.
    pub boxes: [usize; 2],
    /// How they follow.
    pub kind: SplineKind,
    /// The nodes, by position.
    pub nodes: Vec<usize>,
}

/// The boxes at a state, on the structure's axes.
pub(super) struct MovedBoxes {
    placed: PlacedCarriers,
    /// Place of each box's foot and its rotation.
    feet: Vec<(Vector3<f64>, Rotation3<f64>)>,
    /// The boxes.
    pub(super) lattice: Lattice,
}

impl CarriedBoxes {
    /// Of a lattice on the nodes at undeformed places that its spline is tied to.
    pub(super) fn new(
        lattice: &Lattice,
        plane: MirrorPlane,
        kind: SplineKind,
        points: &[Point3<f64>],
        nodes: &[usize],
    ) -> Self {
        let part = CarriedPart { boxes: [0, lattice.len()], kind, nodes: nodes.to_vec() };
        Self::of_parts(lattice, plane, points, &[part])
    }

    /// Of parts that cover the lattice one after the other.
    pub(super) fn of_parts(
        lattice: &Lattice,
        plane: MirrorPlane,
        points: &[Point3<f64>],
        parts: &[CarriedPart],
    ) -> Self {
        let own = |part: &CarriedPart| {
            let boxes = lattice.boxes[part.boxes[0]..part.boxes[1]].to_vec();
            let own = Lattice { boxes, surfaces: Vec::new() };
            match part.kind {
                SplineKind::Beam => feet_on_axis(&own, points, &part.nodes),
                SplineKind::NearestNode => nearest_nodes(&own, points, &part.nodes),
            }
        };
        let feet: Vec<CarriedPoint> = parts.iter().flat_map(own).collect();
        let places: Vec<Vector3<f64>> = points.iter().map(|point| point.coords).collect();
        Self {
            carried: Carried::new(&places, &feet),
            feet,
            nodes: points.len(),
            seams: Seams::of(lattice, plane),
        }
    }

    /// Where the boxes are.
    pub(super) fn moved(&self, lattice: &Lattice, state: &State) -> MovedBoxes {
        let placed = self.carried.placed(state);
        let feet: Vec<_> = (0..self.feet.len()).map(|at| self.carried.place(&placed, at)).collect();
        let carried = |j: usize| {
            let (panel, (place, turned)) = (&lattice.boxes[j], &feet[j]);
            let corner = |corner: Point3<f64>| Point3::from(place + turned * (corner - self.feet[j].origin));
            AeroBox { id: panel.id, corners: panel.corners.map(corner) }
        };
        let boxes = (0..lattice.len()).map(carried).collect();
        let lattice = Lattice { boxes, surfaces: lattice.surfaces.clone() };
        MovedBoxes { placed, feet, lattice }
    }

    /// Displacements of the midpoints of boxes (m) and their spins (rad) in a motion of all nodes (m, rad; g-set, basic axes).
    pub(super) fn motions(&self, lattice: &Lattice, state: &State, motion: &[f64]) -> Vec<[Vector3<f64>; 2]> {
        let each = |motion: &[f64]| -> Vec<f64> {
            let moved = self.moved(lattice, &state.moved_by(motion));
            let one = |(panel, (_, turned)): (&AeroBox, &(Vector3<f64>, Rotation3<f64>))| {
                let turned: Vec<f64> = turned.matrix().iter().copied().collect();
                [panel.mid_point().coords.as_slice(), &turned].concat()
            };
            moved.lattice.boxes.iter().zip(&moved.feet).flat_map(one).collect()
        };
        let now = self.moved(lattice, state);
        let one = |(change, (_, turned)): (&[f64], &(Vector3<f64>, Rotation3<f64>))| {
            let turning = Matrix3::from_column_slice(&change[3..]) * turned.matrix().transpose();
            let spin = |i: usize, j: usize| 0.5 * (turning[(i, j)] - turning[(j, i)]);
            [Vector3::from_column_slice(&change[..3]), Vector3::new(spin(2, 1), spin(0, 2), spin(1, 0))]
        };
        differenced(motion, each).chunks_exact(12).zip(&now.feet).map(one).collect()
    }

    /// Forces and moments on the nodes (N, Nm; g-set) of a force and a moment about the midpoint of each box (N, Nm; the
    /// structure's axes).
    pub(super) fn to_nodes(&self, moved: &MovedBoxes, loads: &[[Vector3<f64>; 2]]) -> Vec<f64> {
        let at_foot = |(j, [force, moment]): (usize, &[Vector3<f64>; 2])| {
            let arm = moved.lattice.boxes[j].mid_point().coords - moved.feet[j].0;
            [*force, moment + arm.cross(force)]
        };
        let loads: Vec<_> = loads.iter().enumerate().map(at_foot).collect();
        self.carried.forces(&moved.placed, &loads, self.nodes)
    }
}

/// A lattice turned about the origin.
pub(super) fn turned(lattice: &Lattice, by: &Rotation3<f64>) -> Lattice {
    let boxes = lattice.boxes.iter();
    let boxes = boxes.map(|panel| AeroBox { id: panel.id, corners: panel.corners.map(|corner| by * corner) });
    Lattice { boxes: boxes.collect(), surfaces: lattice.surfaces.clone() }
}
