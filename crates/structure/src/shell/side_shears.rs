//! Transverse shear along the sides of Nastran's shells: at the middle of each, by the deflections and rotations of its two corners.

use nalgebra::{Point3, SMatrix, Vector2};

/// Direction of the side from a corner to the next one.
pub(super) fn along(corners: &[Point3<f64>], at: usize) -> Vector2<f64> {
    (corners[(at + 1) % corners.len()] - corners[at]).xy().normalize()
}

/// A row a side, over the six motions a corner: `N` sides, `D` motions.
pub(super) fn side_shears<const N: usize, const D: usize>(corners: &[Point3<f64>]) -> SMatrix<f64, N, D> {
    let mut shears = SMatrix::zeros();
    for at in 0..N {
        let next = (at + 1) % N;
        let (length, along) = ((corners[next] - corners[at]).xy().norm(), along(corners, at));
        for (corner, sign) in [(at, -1.0), (next, 1.0)] {
            shears[(at, 6 * corner + 2)] = sign / length;
            shears[(at, 6 * corner + 3)] = -0.5 * along.y;
            shears[(at, 6 * corner + 4)] = 0.5 * along.x;
        }
    }
    shears
}
