//! Where the boxes of a lattice meet.
//!
//! Boxes that are carried one by one come apart a little where the structure between them bends, twists or stretches. A wing's
//! surface does not: in a gap the legs of neighbouring vortices no longer cancel, and a gap of a thousandth of a strip's width
//! changes the lift of strips ten times as narrow as the chord by percents, as if the wing ended there. So vortices run along
//! corners that stay joined: where several boxes met, at the mean of their places. What met its image in a plane of symmetry
//! stays in that plane.

use crate::geometry::AeroBox;
use crate::horseshoe::core;
use crate::lattice::Lattice;
use crate::mirror::MirrorPlane;
use nalgebra::{Point3, Vector3};

/// Corners of a lattice by the places that they share.
#[derive(Debug, Clone, PartialEq)]
pub struct Seams {
    /// What shares each place.
    pub(crate) places: Vec<Meeting>,
    /// The places of the corners of each box.
    pub(crate) corners: Vec<[usize; 4]>,
}

/// Corners that share a place.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Meeting {
    /// Box and corner of each.
    pub(crate) corners: Vec<(usize, usize)>,
    /// y of the plane of symmetry that it is in, m.
    pub(crate) plane_y_m: Option<f64>,
}

impl Seams {
    /// Of a lattice as it was laid out, where corners that meet are nearer to each other than the core of a vortex.
    pub fn of(lattice: &Lattice, plane: MirrorPlane) -> Self {
        let plane_y_m = plane.image().map(|(y_m, _)| y_m);
        // In the order of an oblique line few corners are near each other that do not meet.
        let oblique = Vector3::new(0.31, 0.83, 0.47).normalize();
        let corner = |&(j, at): &(usize, usize)| lattice.boxes[j].corners[at];
        let along = |which: &(usize, usize)| corner(which).coords.dot(&oblique);
        let mut all: Vec<_> = (0..lattice.len()).flat_map(|j| (0..4).map(move |at| (j, at))).collect();
        all.sort_by(|a, b| along(a).total_cmp(&along(b)));
        let near: Vec<f64> = lattice.boxes.iter().map(core).collect();
        let mut seams = Self { places: Vec::new(), corners: vec![[usize::MAX; 4]; lattice.len()] };
        for (first, one) in all.iter().enumerate() {
            if seams.corners[one.0][one.1] != usize::MAX {
                continue;
            }
            let meets = |other: &&(usize, usize)| {
                seams.corners[other.0][other.1] == usize::MAX
                    && (corner(one) - corner(other)).norm() <= near[one.0].min(near[other.0])
            };
            let reach = all[first..].iter().take_while(|other| along(other) - along(one) <= near[one.0]);
            let corners: Vec<_> = reach.filter(meets).copied().collect();
            for (j, at) in &corners {
                seams.corners[*j][*at] = seams.places.len();
            }
            let plane_y_m = plane_y_m.filter(|y_m| (corner(one).y - y_m).abs() <= near[one.0]);
            seams.places.push(Meeting { corners, plane_y_m });
        }
        seams
    }

    /// The lattice with its boxes moved, its corners joined again.
    ///
    /// # Panics
    /// If it has other boxes.
    pub fn closed(&self, moved: &Lattice) -> Lattice {
        assert_eq!(moved.len(), self.corners.len(), "a lattice of another number of boxes");
        let mean = |meeting: &Meeting| {
            let corners = meeting.corners.iter();
            let sum: Vector3<f64> = corners.map(|(j, at)| moved.boxes[*j].corners[*at].coords).sum();
            let mean = sum / meeting.corners.len() as f64;
            Point3::new(mean.x, meeting.plane_y_m.unwrap_or(mean.y), mean.z)
        };
        let places: Vec<Point3<f64>> = self.places.iter().map(mean).collect();
        let boxes = moved.boxes.iter().zip(&self.corners);
        let boxes = boxes.map(|(panel, own)| AeroBox { id: panel.id, corners: own.map(|at| places[at]) });
        Lattice { boxes: boxes.collect(), surfaces: moved.surfaces.clone() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn corners_that_met_stay_together_and_others_apart() {
        let wing = Lattice::trapezoid(1, [0.0, 0.0, 0.0], 1.0, [0.4, 3.0, 0.0], 0.7, [2, 3]).expect("boxes");
        // beside it on the same edge, and a tail above
        let root =
            Lattice::trapezoid(100, [0.0, -0.5, 0.0], 1.0, [0.0, 0.0, 0.0], 1.0, [2, 1]).expect("boxes");
        let tail =
            Lattice::trapezoid(200, [0.0, 0.0, 0.2], 1.0, [0.4, 3.0, 0.2], 0.7, [1, 1]).expect("boxes");
        let mut all = wing.joined(&root).and_then(|both| both.joined(&tail)).expect("one lattice");
        let seams = Seams::of(&all, MirrorPlane::Symmetric { y_m: -0.5 });
        // 3 by 4 corners of the wing, 3 more of the root, 4 of the tail
        assert_eq!(seams.places.len(), 12 + 3 + 4);
        assert_eq!(seams.closed(&all), all, "nothing moves where nothing has moved");
        let middle = seams.corners[0][2];
        let before = all.boxes[0].corners[2];
        assert_eq!(seams.places[middle].corners.len(), 4);
        all.boxes[0].corners[2] += Vector3::new(0.0, 0.04, 0.08);
        all.boxes[6].corners[0] += Vector3::new(0.01, 0.01, 0.01);
        let closed = seams.closed(&all);
        let moved = closed.boxes[6].corners[0] - Point3::new(0.0, -0.5, 0.0);
        assert_eq!((moved.x, moved.y, moved.z), (0.01, 0.0, 0.01), "it stays in the plane");
        for (j, at) in &seams.places[middle].corners {
            let moved = closed.boxes[*j].corners[*at] - before;
            assert!((moved - Vector3::new(0.0, 0.01, 0.02)).norm() < 1e-15, "box {j} by {moved}");
        }
    }

    /// A hundredth of the smaller box is where a vortex's core ends.
    #[test]
    fn corners_meet_within_the_core_of_the_smaller_box_and_the_plane_within_their_own() {
        for size in [0.01, 1.0, 50.0] {
            let panel = |id: u32, from: f64, to: f64, chord: f64, lead: f64| {
                Lattice::trapezoid(id, [lead, from, 0.0], chord, [lead, to, 0.0], chord, [1, 1])
                    .map(|lattice| lattice.scaled(size))
                    .expect("a box")
            };
            // Beside each other in either order; the small one's core is 0.002, the large one's 0.01.
            for (gap, meets) in [(0.0, true), (0.0015, true), (0.004, false), (0.02, false)] {
                for order in [false, true] {
                    let large = panel(1, 0.0, 1.0, 1.0, 0.0);
                    let small = panel(9, 1.0 + gap, 1.2 + gap, 0.3, 0.0);
                    let pair = if order { small.joined(&large) } else { large.joined(&small) };
                    let seams = Seams::of(&pair.expect("two boxes"), MirrorPlane::None);
                    // Leading edges alone are in line.
                    assert_eq!(seams.places.len(), if meets { 7 } else { 8 }, "gap {gap}, size {size}");
                    let most = seams.places.iter().map(|place| place.corners.len()).max();
                    assert_eq!(most, Some(if meets { 2 } else { 1 }));
                    assert!(seams.corners.iter().flatten().all(|place| *place < seams.places.len()));
                }
            }
            for (gap, within) in [(0.0, true), (0.008, true), (-0.008, true), (0.012, false), (-0.012, false)]
            {
                let y_m = (2.0 - gap) * size;
                let seams = Seams::of(&panel(1, 2.0, 3.0, 1.0, 0.0), MirrorPlane::Antisymmetric { y_m });
                let held = seams.places.iter().filter(|place| place.plane_y_m == Some(y_m)).count();
                assert_eq!(held, if within { 2 } else { 0 }, "{gap} from the plane, size {size}");
            }
        }
    }
}
