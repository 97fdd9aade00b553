//! The triangle's strain operators: linear, MITC3 shear.

use super::point::Point;
use nalgebra::{Matrix2, Point3, RowSVector, SMatrix, Vector2};

/// Derivatives of the shape functions 1 - r - s, r, s by r and s.
const NATURAL: [[f64; 2]; 3] = [[-1.0, -1.0], [1.0, 0.0], [0.0, 1.0]];

/// Natural coordinates of the corners.
pub(super) const CORNERS: [[f64; 2]; 3] = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]];

/// Three points inside, exact to second degree, each of [`WEIGHT`].
pub(super) const PLACES: [[f64; 2]; 3] =
    [[1.0 / 6.0, 1.0 / 6.0], [2.0 / 3.0, 1.0 / 6.0], [1.0 / 6.0, 2.0 / 3.0]];

/// Weight of a place: a third of the triangle's half of the unit square.
pub(super) const WEIGHT: f64 = 1.0 / 6.0;

pub(super) fn points(corners: &[Point3<f64>]) -> Vec<Point<18>> {
    PLACES.map(|at| point(corners, at, WEIGHT)).into()
}

/// The operators at r, s with integration weight `weight`.
pub(super) fn point(corners: &[Point3<f64>], at: [f64; 2], weight: f64) -> Point<18> {
    // Rows (x, y) by r and by s.
    let j = Matrix2::new(
        corners[1][0] - corners[0][0],
        corners[1][1] - corners[0][1],
        corners[2][0] - corners[0][0],
        corners[2][1] - corners[0][1],
    );
    let inverse = j.try_inverse().unwrap_or_else(Matrix2::zeros);
    let shapes = [1.0 - at[0] - at[1], at[0], at[1]];
    let mut membrane = SMatrix::<f64, 3, 18>::zeros();
    let mut bending = SMatrix::<f64, 3, 18>::zeros();
    let mut drilling = RowSVector::<f64, 18>::zeros();
    for (node, slope) in NATURAL.iter().enumerate() {
        let slope = inverse * Vector2::from(*slope);
        let (c, x, y) = (6 * node, slope.x, slope.y);
        membrane[(0, c)] = x;
        membrane[(1, c + 1)] = y;
        membrane[(2, c)] = y;
        membrane[(2, c + 1)] = x;
        bending[(0, c + 4)] = x;
        bending[(1, c + 3)] = -y;
        bending[(2, c + 4)] = y;
        bending[(2, c + 3)] = -x;
        drilling[c] = 0.5 * y;
        drilling[c + 1] = -0.5 * x;
        drilling[c + 5] = shapes[node];
    }
    let shear = inverse * covariant_shear(&j, at);
    Point {
        area_m2: weight * j.determinant(),
        thickness: 1.0,
        shape: shapes.to_vec(),
        membrane,
        bending,
        shear,
        drilling,
        modes: SMatrix::zeros(),
        mode_drilling: RowSVector::zeros(),
    }
}

/// Covariant transverse shears, constant along each side and equal to its tied value there: with the shears
/// r1, s1 at the middle of side 1-2 and so on, `e_r` = r1 + c s, `e_s` = s2 - c r, c = (s2 - r1) - (s3 - r3).
fn covariant_shear(j: &Matrix2<f64>, at: [f64; 2]) -> SMatrix<f64, 2, 18> {
    let tied = |direction: usize, r: f64, s: f64| {
        let shapes = [1.0 - r - s, r, s];
        let mut row = RowSVector::<f64, 18>::zeros();
        for node in 0..3 {
            let c = 6 * node;
            row[c + 2] = NATURAL[node][direction];
            row[c + 3] = -j[(direction, 1)] * shapes[node];
            row[c + 4] = j[(direction, 0)] * shapes[node];
        }
        row
    };
    let r1 = tied(0, 0.5, 0.0);
    let s2 = tied(1, 0.0, 0.5);
    let (r3, s3) = (tied(0, 0.5, 0.5), tied(1, 0.5, 0.5));
    let c = (s2 - r1) - (s3 - r3);
    let mut rows = SMatrix::<f64, 2, 18>::zeros();
    rows.set_row(0, &(r1 + c * at[1]));
    rows.set_row(1, &(s2 - c * at[0]));
    rows
}
