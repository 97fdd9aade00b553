//! The triangle's membrane with drilling rotations (CTRIAR): the optimal triangle of Felippa's assumed natural deviatoric
//! strains, *A study of optimal membrane triangles with drilling freedoms*, Comput. Methods Appl. Mech. Eng. 192 (2003).
//!
//! Its strains are a constant part, those of the boundary's motion (a side's normal motion is that of a cubic beam's),
//! and a deviatoric part that is linear and has no mean, by the corners' rotations less that of the triangle. Where two of
//! them make a rectangle, bending in its plane takes an isotropic beam's energy, whatever the ratio of the sides; constant
//! stress is exact in any mesh.

use super::point::Point;
use super::triangle;
use nalgebra::{Matrix3, Point3, SMatrix, Vector3};

/// How much of a side's normal motion is the rotations' (Felippa's alpha of the basic stiffness).
const BOUNDARY: f64 = 1.5;

/// Smallest factor of the deviatoric part: at Poisson ratios near one half the optimal one vanishes.
const SMALLEST: f64 = 0.01;

/// Rows of the optimal deviatoric strains along the sides 12, 23, 31 by the three rotations, at corner 1.
const AT_CORNER: [[f64; 3]; 3] = [[1.0, 2.0, 1.0], [0.0, 1.0, -1.0], [-1.0, -1.0, -2.0]];

/// The operators at the triangle's points of integration, with this membrane; `membrane` is the section's.
pub(super) fn points(corners: &[Point3<f64>], membrane: &Matrix3<f64>) -> Vec<Point<18>> {
    let places = triangle::PLACES;
    places.map(|at| point(corners, at, triangle::WEIGHT, membrane)).into()
}

/// The operators at r, s with integration weight `weight`.
pub(super) fn point(
    corners: &[Point3<f64>],
    at: [f64; 2],
    weight: f64,
    membrane: &Matrix3<f64>,
) -> Point<18> {
    let mut point = triangle::point(corners, at, weight);
    let Some(share) = deviatoric_share(membrane) else { return point };
    point.membrane = constant(corners) + deviatoric(corners, at) * (1.5 * share.sqrt());
    point.drilling.fill(0.0);
    point
}

/// The factor of the deviatoric stiffness that makes bending in the plane exact: (1 - 4 nu^2) / 2 where the section is
/// isotropic, elsewhere Felippa's invariant of `membrane` under turns, 256 det E / W - 3/2. Nothing without a membrane.
fn deviatoric_share(membrane: &Matrix3<f64>) -> Option<f64> {
    let scale = membrane.amax();
    let e = membrane / if scale > 0.0 { scale } else { return None };
    let (e11, e22, e33) = (e[(0, 0)], e[(1, 1)], e[(2, 2)]);
    let (e12, e13, e23) = (e[(0, 1)], e[(0, 2)], e[(1, 2)]);
    let (s1, s2, cross) = (e13 * e13, e23 * e23, e13 * e23);
    let invariant = -6.0 * e12.powi(3) + 5.0 * e11 * e22 * (e11 + e22) - 5.0 * e12 * e12 * (e11 + e22)
        + 6.0 * e11 * e12 * e22
        - e22 * (75.0 * s1 + 14.0 * cross + 3.0 * s2)
        - e11 * (3.0 * s1 + 14.0 * cross + 75.0 * s2)
        + 2.0 * e12 * (7.0 * s1 + 46.0 * cross + 7.0 * s2)
        + (3.0 * (e11 * e11 + e22 * e22) + 82.0 * e11 * e22 - 24.0 * e12 * e12) * e33
        - 4.0 * (5.0 * s1 - 6.0 * cross + 5.0 * s2) * e33
        + 4.0 * (5.0 * e11 - 6.0 * e12 + 5.0 * e22) * e33 * e33;
    let share = 256.0 * e.determinant() / invariant - 1.5;
    share.is_finite().then(|| share.max(SMALLEST))
}

/// Sides opposite the corners: from the next corner to the one after it.
fn side(corners: &[Point3<f64>], corner: usize) -> [f64; 2] {
    let (from, to) = (corners[(corner + 1) % 3], corners[(corner + 2) % 3]);
    [to[0] - from[0], to[1] - from[1]]
}

/// Twice the area.
fn double_area(corners: &[Point3<f64>]) -> f64 {
    let ([ax, ay], [bx, by]) = (side(corners, 1), side(corners, 2));
    ax * by - ay * bx
}

/// The constant strains: the boundary's motion, by Gauss.
fn constant(corners: &[Point3<f64>]) -> SMatrix<f64, 3, 18> {
    let mut strains = SMatrix::zeros();
    let double = double_area(corners);
    for node in 0..3 {
        let c = 6 * node;
        let ([ox, oy], [nx, ny], [px, py]) =
            (side(corners, node), side(corners, (node + 1) % 3), side(corners, (node + 2) % 3));
        // Outward normals times lengths of the adjoining sides: (y, -x); the opposite side's gives the displacement's part.
        strains[(0, c)] = -oy / double;
        strains[(1, c + 1)] = ox / double;
        strains[(2, c)] = ox / double;
        strains[(2, c + 1)] = -oy / double;
        // nx, ny end at the node's predecessor, px, py at the node: their difference is what turns the boundary.
        let turn = BOUNDARY / (6.0 * double);
        strains[(0, c + 5)] = turn * (ny * ny - py * py);
        strains[(1, c + 5)] = turn * (nx * nx - px * px);
        strains[(2, c + 5)] = 2.0 * turn * (px * py - nx * ny);
    }
    strains
}

/// The deviatoric strains at r, s, without their factor.
fn deviatoric(corners: &[Point3<f64>], at: [f64; 2]) -> SMatrix<f64, 3, 18> {
    let double = double_area(corners);
    // Sides 12, 23, 31 lie opposite corners 3, 1, 2.
    let sides = [side(corners, 2), side(corners, 0), side(corners, 1)];
    let lengths = sides.map(|[x, y]| x * x + y * y);
    // Natural strains along the sides by those in x, y; inverted by a matrix that is never singular for a proper triangle.
    let natural = Matrix3::from_fn(|row, column| {
        let [x, y] = sides[row];
        [x * x, y * y, x * y][column] / lengths[row]
    });
    let Some(cartesian) = natural.try_inverse() else { return SMatrix::zeros() };
    let weights = [1.0 - at[0] - at[1], at[0], at[1]];
    let mut along_sides = Matrix3::<f64>::zeros();
    for (corner, weight) in weights.iter().enumerate() {
        for row in 0..3 {
            for column in 0..3 {
                let value = AT_CORNER[(row + 3 - corner) % 3][(column + 3 - corner) % 3];
                along_sides[(row, column)] += weight * value;
            }
        }
    }
    for (row, square) in lengths.iter().enumerate() {
        // Twice the area by three, over the side's square.
        along_sides.row_mut(row).scale_mut(double / (3.0 * square));
    }
    cartesian * along_sides * hierarchical(corners, double)
}

/// The corners' rotations less that of the triangle as a whole.
fn hierarchical(corners: &[Point3<f64>], double: f64) -> SMatrix<f64, 3, 18> {
    let mut turned = SMatrix::<f64, 3, 18>::zeros();
    for node in 0..3 {
        let [x, y] = side(corners, node);
        let whole = Vector3::repeat(0.5 / double);
        turned.column_mut(6 * node).copy_from(&(whole * x));
        turned.column_mut(6 * node + 1).copy_from(&(whole * y));
        turned[(node, 6 * node + 5)] = 1.0;
    }
    turned
}
