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
