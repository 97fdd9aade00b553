//! Shape functions of elements with grids at the middle of their edges.
//!
//! An edge's grid has a bubble M that is one there and zero at all other grids; the functions of the corners are the linear
//! ones less half the bubbles of their edges, N = L - (M1 + M2 ..) / 2. These are the quadratic functions of the triangle and the
//! tetrahedron and the serendipity functions of the quadrilateral, the hexahedron and the wedge (Zienkiewicz and Taylor, *The Finite
//! Element Method*, vol. 1, ch. 8). An edge without a grid has no bubble and is straight.

use nalgebra::Vector3;

/// Functions of all grids (corners, then the edges that have one) at a place, and their derivatives by the local coordinates.
#[derive(Debug, Clone, Default)]
pub(crate) struct Functions {
    pub(crate) values: Vec<f64>,
    pub(crate) slopes: Vec<Vector3<f64>>,
}

/// An edge: its corners, and what its bubble is made of.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Edge {
    /// Along a local coordinate x from -1 to 1: (1 - x^2) (La + Lb).
    Along(usize, [usize; 2]),
    /// Of a triangle or tetrahedron: 4 La Lb.
    Between([usize; 2]),
    /// Of a wedge's triangle 123 (false) or 456 (true): 4 La Lb of the triangle times the height's linear function.
    OfWedge([usize; 2], bool),
}

use Edge::{Along, Between, OfWedge};

/// Edges of CTRIA6.
pub(crate) const TRIANGLE: [Edge; 3] = [Between([0, 1]), Between([1, 2]), Between([2, 0])];
/// Edges of CQUAD8.
pub(crate) const QUADRILATERAL: [Edge; 4] =
    [Along(0, [0, 1]), Along(1, [1, 2]), Along(0, [2, 3]), Along(1, [3, 0])];
/// Edges of CTETRA.
pub(crate) const TETRAHEDRON: [Edge; 6] =
    [Between([0, 1]), Between([1, 2]), Between([2, 0]), Between([0, 3]), Between([1, 3]), Between([2, 3])];
/// Edges of CPENTA.
pub(crate) const WEDGE: [Edge; 9] = [
    OfWedge([0, 1], false),
    OfWedge([1, 2], false),
    OfWedge([2, 0], false),
    Along(2, [0, 3]),
    Along(2, [1, 4]),
    Along(2, [2, 5]),
    OfWedge([3, 4], true),
    OfWedge([4, 5], true),
    OfWedge([5, 3], true),
];
/// Edges of CHEXA.
pub(crate) const HEXAHEDRON: [Edge; 12] = [
    Along(0, [0, 1]),
    Along(1, [1, 2]),
    Along(0, [2, 3]),
    Along(1, [3, 0]),
    Along(2, [0, 4]),
    Along(2, [1, 5]),
    Along(2, [2, 6]),
    Along(2, [3, 7]),
    Along(0, [4, 5]),
    Along(1, [5, 6]),
    Along(0, [6, 7]),
    Along(1, [7, 4]),
];

impl Edge {
    /// The corners at its ends.
    pub(crate) fn ends(self) -> [usize; 2] {
        match self {
            Along(_, ends) | Between(ends) | OfWedge(ends, _) => ends,
        }
    }

    /// The bubble and its slopes, from the corners' linear functions.
    fn bubble(self, linear: &Functions, at: [f64; 3]) -> (f64, Vector3<f64>) {
        let sum = |corners: &[usize]| {
            let value: f64 = corners.iter().map(|corner| linear.values[*corner]).sum();
            (value, corners.iter().map(|corner| linear.slopes[*corner]).sum::<Vector3<f64>>())
        };
        match self {
            Along(axis, ends) => {
                let (across, slope) = sum(&ends);
                let along = 1.0 - at[axis] * at[axis];
                (along * across, slope * along - Vector3::ith(axis, 2.0 * at[axis] * across))
            }
            Between([a, b]) => product(sum(&[a]), sum(&[b]), (1.0, Vector3::zeros())),
            OfWedge([a, b], is_upper) => {
                let level = if is_upper { [3, 4, 5] } else { [0, 1, 2] };
                let column = |corner: usize| sum(&[corner, (corner + 3) % 6]);
                product(column(a), column(b), sum(&level))
            }
        }
    }
}

/// Four times the product of three functions.
fn product(
    (a, by_a): (f64, Vector3<f64>),
    (b, by_b): (f64, Vector3<f64>),
    (c, by_c): (f64, Vector3<f64>),
) -> (f64, Vector3<f64>) {
    (4.0 * a * b * c, (by_a * (b * c) + by_b * (a * c) + by_c * (a * b)) * 4.0)
}

/// The functions with grids on `edges`, from the `linear` ones of the corners, at local coordinates `at`.
pub(crate) fn with_midsides(
    mut linear: Functions,
    edges: impl Iterator<Item = Edge>,
    at: [f64; 3],
) -> Functions {
    let bubbles: Vec<_> = edges.map(|edge| (edge.ends(), edge.bubble(&linear, at))).collect();
    for (ends, (value, slope)) in bubbles {
        for end in ends {
            linear.values[end] -= 0.5 * value;
            linear.slopes[end] -= slope * 0.5;
        }
        linear.values.push(value);
        linear.slopes.push(slope);
    }
    linear
}

/// Linear functions of a quadrilateral's corners at xi, eta from -1 to 1.
pub(crate) fn quadrilateral([x, y]: [f64; 2]) -> Functions {
    let corners = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)];
    Functions {
        values: corners.map(|(a, b)| 0.25 * (1.0 + a * x) * (1.0 + b * y)).into(),
        slopes: corners
            .map(|(a, b)| Vector3::new(0.25 * a * (1.0 + b * y), 0.25 * b * (1.0 + a * x), 0.0))
            .into(),
    }
}

/// Linear functions of a triangle's corners at r, s.
pub(crate) fn triangle([r, s]: [f64; 2]) -> Functions {
    Functions {
        values: vec![1.0 - r - s, r, s],
        slopes: vec![Vector3::new(-1.0, -1.0, 0.0), Vector3::x(), Vector3::y()],
    }
}

/// Lumped masses of grids that share `total` in proportion to their own consistent masses: sums of rows would be negative
/// at corners (Hinton, Rock and Zienkiewicz, Earthquake Eng. Struct. Dyn. 4, 1976).
pub(crate) fn lumped(consistent: &[f64], total: f64) -> Vec<f64> {
    let sum: f64 = consistent.iter().sum();
    consistent.iter().map(|own| total * own / sum).collect()
}

#[cfg(test)]
mod tests;
