//! A lattice that is its own mirror image about y = 0, solved as its symmetric and its antisymmetric half.
//!
//! With r the right half, l the left and m the boxes in the plane itself (a fin), everything is a sum of a part that the
//! mirror keeps and one whose sign it changes. Boxes in the plane have part in the second only, as the mirror turns
//! their normals round. The two halves know nothing of each other: half the influences, a quarter of the factorisation.

use crate::AeroBox;
use crate::lattice::Lattice;
use faer::{Mat, MatRef, c64};
use nalgebra::Point3;

/// Boxes that differ from a mirror image by less than this times their size are that image.
const TOLERANCE: f64 = 1e-9;

/// Which box of a symmetric lattice is whose mirror image.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Halves {
    /// Right boxes and the left ones opposite; -1 if the left one's normal is not the right one's mirror image but the
    /// opposite of that.
    pairs: Vec<(usize, usize, f64)>,
    /// Boxes in the plane.
    middle: Vec<usize>,
}

impl Halves {
    /// `None` if the lattice is not symmetric, or has nothing to pair.
    pub(super) fn find(lattice: &Lattice) -> Option<Self> {
        let mut sides: [Vec<usize>; 3] = Default::default();
        for (index, panel) in lattice.boxes.iter().enumerate() {
            sides[side(panel)?].push(index);
        }
        let [left, middle, right] = sides;
        if right.is_empty() || right.len() != left.len() {
            return None;
        }
        let x = |index: usize| lattice.boxes[index].mid_point().x;
        let mut sorted = left;
        sorted.sort_by(|a, b| x(*a).total_cmp(&x(*b)));
        let mut taken = vec![false; sorted.len()];
        let mut pairs = Vec::with_capacity(right.len());
        for index in right {
            let panel = &lattice.boxes[index];
            let reach = TOLERANCE * panel.area_m2().sqrt();
            let first = sorted.partition_point(|other| x(*other) < x(index) - reach);
            let near = (first..sorted.len()).take_while(|i| x(sorted[*i]) <= x(index) + reach);
            let (place, flip) = near
                .filter(|i| !taken[*i])
                .find_map(|i| opposite(panel, &lattice.boxes[sorted[i]], reach).map(|flip| (i, flip)))?;
            taken[place] = true;
            pairs.push((index, sorted[place], flip));
        }
        Some(Self { pairs, middle })
    }

    /// The right boxes and those in the plane.
    pub(super) fn kept(&self, lattice: &Lattice) -> Lattice {
        let indices = self.pairs.iter().map(|(right, ..)| right).chain(&self.middle);
        Lattice { boxes: indices.map(|i| lattice.boxes[*i].clone()).collect(), surfaces: Vec::new() }
    }

    /// How many pairs.
    pub(super) fn pairs(&self) -> usize {
        self.pairs.len()
    }

    /// Parts of incidences that are symmetric (pairs by columns) and antisymmetric (kept boxes by columns).
    pub(super) fn split(&self, w: MatRef<'_, c64>) -> [Mat<c64>; 2] {
        let part = |sign: f64| {
            move |i: usize, column: usize| {
                let (right, left, flip) = self.pairs[i];
                (w[(right, column)] + w[(left, column)] * (sign * flip)) * 0.5
            }
        };
        let count = self.pairs.len();
        let other = |i: usize, column: usize| {
            if i < count { part(-1.0)(i, column) } else { w[(self.middle[i - count], column)] }
        };
        [Mat::from_fn(count, w.ncols(), part(1.0)), Mat::from_fn(count + self.middle.len(), w.ncols(), other)]
    }

    /// The sum of a symmetric and an antisymmetric part, for all boxes.
    pub(super) fn join(&self, [symmetric, antisymmetric]: [Mat<c64>; 2]) -> Mat<c64> {
        let count = self.pairs.len();
        let mut whole = Mat::zeros(2 * count + self.middle.len(), symmetric.ncols());
        for column in 0..symmetric.ncols() {
            for (i, (right, left, flip)) in self.pairs.iter().enumerate() {
                let (same, other) = (symmetric[(i, column)], antisymmetric[(i, column)]);
                whole[(*right, column)] = same + other;
                whole[(*left, column)] = (same - other) * *flip;
            }
            for (i, middle) in self.middle.iter().enumerate() {
                whole[(*middle, column)] = antisymmetric[(count + i, column)];
            }
        }
        whole
    }

    /// The whole influence matrix from that of the kept boxes on each other and that of their images on them.
    pub(super) fn unfolded(&self, own: &Mat<c64>, image: &Mat<c64>) -> Mat<c64> {
        let count = self.pairs.len();
        // Index among the kept boxes, side of the plane, factor from the kept box's mirror image to the box.
        let mut places = vec![(0, 0.0, 1.0); 2 * count + self.middle.len()];
        for (i, (right, left, flip)) in self.pairs.iter().enumerate() {
            places[*right] = (i, 1.0, 1.0);
            places[*left] = (i, -1.0, *flip);
        }
        for (i, middle) in self.middle.iter().enumerate() {
            places[*middle] = (count + i, 0.0, 1.0);
        }
        Mat::from_fn(places.len(), places.len(), |i, j| {
            let ((i, side_i, flip_i), (j, side_j, flip_j)) = (places[i], places[j]);
            let factor = flip_i * flip_j;
            if side_i * side_j < 0.0 || (side_i == 0.0 && side_j < 0.0) {
                image[(i, j)] * factor
            } else if side_j == 0.0 && side_i < 0.0 {
                own[(i, j)] * -factor
            } else {
                own[(i, j)] * factor
            }
        })
    }
}

/// 0 left, 1 in the plane, 2 right; none for a box across the plane.
fn side(panel: &AeroBox) -> Option<usize> {
    let reach = TOLERANCE * panel.area_m2().sqrt();
    let (low, high) = panel
        .corners
        .iter()
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), c| (low.min(c.y), high.max(c.y)));
    match (low < -reach, high > reach) {
        (true, true) => None,
        (true, false) => Some(0),
        (false, false) => Some(1),
        (false, true) => Some(2),
    }
}

/// Whether two boxes are mirror images: 1 if their normals are too, -1 if those are opposite to that.
fn opposite(right: &AeroBox, left: &AeroBox, reach: f64) -> Option<f64> {
    let flip = |p: &Point3<f64>| Point3::new(p.x, -p.y, p.z);
    let [c1, c2, c3, c4] = right.corners.each_ref().map(flip);
    let same =
        |image: [Point3<f64>; 4]| image.iter().zip(&left.corners).all(|(a, b)| (a - b).norm() <= reach);
    // As `Lattice::mirrored` numbers the corners: sides exchanged. The other way round the normal is opposite.
    if same([c4, c3, c2, c1]) {
        Some(1.0)
    } else if same([c1, c2, c3, c4]) {
        Some(-1.0)
    } else {
        None
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn panel(id: u32, from: [f64; 3], to: [f64; 3], divisions: [u32; 2]) -> Lattice {
        Lattice::trapezoid(id, from, 1.0, to, 1.0, divisions).expect("boxes")
    }

    fn joined(parts: &[&Lattice]) -> Lattice {
        parts.iter().fold(Lattice::default(), |all, part| all.joined(part).expect("one lattice"))
    }

    fn mirror(p: &Point3<f64>) -> Point3<f64> {
        Point3::new(p.x, -p.y, p.z)
    }

    /// A right wing of two strips, its image, one of a single box above each, a fin.
    fn aircraft() -> Lattice {
        let right = panel(1, [0.0, 0.0, 0.0], [0.0, 2.0, 0.0], [2, 2]);
        let left = panel(101, [0.0, -2.0, 0.0], [0.0, 0.0, 0.0], [2, 2]);
        let above = panel(201, [0.0, 0.5, 1.0], [0.0, 1.5, 1.0], [1, 1]);
        // From the middle to the tip: its normal is down where that of the right one is up.
        let other = panel(301, [0.0, -0.5, 1.0], [0.0, -1.5, 1.0], [1, 1]);
        let fin = panel(401, [1.0, 0.0, 0.0], [1.0, 0.0, 1.0], [2, 1]);
        joined(&[&left, &other, &fin, &right, &above])
    }

    #[test]
    fn every_right_box_finds_its_image_among_boxes_in_line_and_above() {
        let lattice = aircraft();
        let halves = Halves::find(&lattice).expect("a symmetric lattice");
        assert_eq!((halves.pairs(), halves.middle.as_slice()), (5, [5, 6].as_slice()));
        let mut taken: Vec<usize> = halves.pairs.iter().map(|pair| pair.1).collect();
        taken.sort_unstable();
        assert_eq!(taken, [0, 1, 2, 3, 4]);
        for (right, left, flip) in &halves.pairs {
            let (one, other) = (&lattice.boxes[*right], &lattice.boxes[*left]);
            assert!((mirror(&one.mid_point()) - other.mid_point()).norm() < 1e-14);
            let image = mirror(&Point3::from(one.normal()));
            assert!((image - Point3::from(other.normal() * *flip)).norm() < 1e-14, "{right} {left} {flip}");
            assert_eq!(*flip, if lattice.boxes[*right].id == 201 { -1.0 } else { 1.0 });
        }
        let kept = halves.kept(&lattice);
        let ids: Vec<u32> = kept.boxes.iter().map(|panel| panel.id).collect();
        assert_eq!(ids, [1, 2, 3, 4, 201, 401, 402]);
    }

    #[test]
    fn what_is_not_symmetric_or_has_nothing_to_pair_is_none() {
        let right = panel(1, [0.0, 0.0, 0.0], [0.0, 2.0, 0.0], [1, 2]);
        let left = panel(101, [0.0, -2.0, 0.0], [0.0, 0.0, 0.0], [1, 2]);
        let fin = panel(201, [1.0, 0.0, 0.0], [1.0, 0.0, 1.0], [2, 1]);
        let half = panel(301, [0.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1, 1]);
        let across = panel(401, [0.0, -0.5, 0.0], [0.0, 0.5, 0.0], [1, 1]);
        let upright = panel(501, [0.0, -1.0, 0.0], [0.0, -1.0, 1.0], [1, 2]);
        assert!(Halves::find(&joined(&[&right, &left])).is_some());
        let none: [&[&Lattice]; 7] = [
            &[],
            &[&fin],
            &[&right],
            &[&left, &fin],
            &[&half, &left],
            &[&left, &right, &across],
            &[&right, &upright],
        ];
        for parts in none {
            assert_eq!(Halves::find(&joined(parts)), None, "{:?}", joined(parts).surfaces);
        }
    }

    /// Half of a billionth of a box off is an image still, three of them are not, in any direction and at any size.
    #[test]
    fn images_are_told_to_a_billionth_of_a_box() {
        for size in [0.01, 1.0, 100.0] {
            for axis in 0..3 {
                for (off, pairs) in [(0.5e-9, true), (-0.5e-9, true), (3e-9, false), (-3e-9, false)] {
                    let right = panel(1, [0.3, 1.0, 0.2], [0.3, 2.0, 0.2], [1, 1]);
                    let mut left = panel(101, [0.3, -2.0, 0.2], [0.3, -1.0, 0.2], [1, 1]);
                    left.boxes[0].corners.iter_mut().for_each(|corner| corner[axis] += off);
                    let both = joined(&[&right, &left]).scaled(size);
                    assert_eq!(Halves::find(&both).is_some(), pairs, "{off} along {axis}, size {size}");
                }
            }
            // The plane: a wing may overlap it by as much, and a fin stand as much beside it.
            for (off, whole) in [(-0.5e-9, true), (-3e-9, false)] {
                let right = panel(1, [0.3, off, 0.2], [0.3, 1.0, 0.2], [1, 1]);
                let left = panel(101, [0.3, -1.0, 0.2], [0.3, -off, 0.2], [1, 1]);
                let found = Halves::find(&joined(&[&right, &left]).scaled(size));
                assert_eq!(found.is_some(), whole, "{off} over the plane, size {size}");
                for side in [off, -off] {
                    let right = panel(1, [0.3, 0.0, 0.2], [0.3, 1.0, 0.2], [1, 1]);
                    let left = panel(101, [0.3, -1.0, 0.2], [0.3, 0.0, 0.2], [1, 1]);
                    let fin = panel(201, [0.3, side, 1.0], [0.3, side, 2.0], [1, 1]);
                    let found = Halves::find(&joined(&[&right, &left, &fin]).scaled(size));
                    assert_eq!(found.is_some(), whole, "a fin at {side}, size {size}");
                }
            }
        }
    }

    /// Any incidences are the sum of their parts; the mirror keeps the one and changes the sign of the other.
    #[test]
    fn parts_of_incidences_add_up_to_them_and_have_the_symmetry_of_their_name() {
        let lattice = aircraft();
        let halves = Halves::find(&lattice).expect("a symmetric lattice");
        let w = Mat::from_fn(lattice.len(), 2, |i, j| c64::new((1.3 * i as f64).sin(), (i + 3 * j) as f64));
        let [same, other] = halves.split(w.as_ref());
        assert_eq!((same.nrows(), other.nrows()), (5, 7));
        assert!((halves.join([same.clone(), other.clone()]) - &w).norm_max() < 1e-14);
        let none = |rows: usize| Mat::zeros(rows, 2);
        for (whole, sign) in [(halves.join([same, none(7)]), 1.0), (halves.join([none(5), other]), -1.0)] {
            for column in 0..2 {
                for (right, left, flip) in &halves.pairs {
                    let image = whole[(*right, column)] * (sign * flip);
                    assert!((whole[(*left, column)] - image).norm() < 1e-14);
                }
            }
        }
    }
}
