//! The quadrilateral's strain operators: bilinear, MITC4 shear, four incompatible membrane modes.
//!
//! Corners are (x, y, height above the element's plane). A warped surface z(x, y) stretches by its slopes times those of
//! the deflection (Marguerre's shallow shell): e_x = u,x + z,x w,x and so on, which leaves rigid motions free of strain.

use super::point::Point;
use nalgebra::{Matrix2, Point3, RowSVector, SMatrix, Vector2};

/// Natural coordinates of the corners.
pub(super) const CORNERS: [[f64; 2]; 4] = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];

/// The 2 x 2 Gauss points.
pub(super) fn points(corners: &[Point3<f64>]) -> Vec<Point<24>> {
    let g = 1.0 / 3.0_f64.sqrt();
    CORNERS.iter().map(|corner| point(corners, [g * corner[0], g * corner[1]], 1.0)).collect()
}

fn shape(at: [f64; 2]) -> [f64; 4] {
    CORNERS.map(|c| 0.25 * (1.0 + c[0] * at[0]) * (1.0 + c[1] * at[1]))
}

/// Derivatives of the shape functions by the natural coordinates.
fn natural(at: [f64; 2]) -> [[f64; 2]; 4] {
    CORNERS.map(|c| [0.25 * c[0] * (1.0 + c[1] * at[1]), 0.25 * c[1] * (1.0 + c[0] * at[0])])
}

/// J: rows (x, y) by xi and by eta.
fn jacobian(corners: &[Point3<f64>], at: [f64; 2]) -> Matrix2<f64> {
    let mut j = Matrix2::zeros();
    for (slope, corner) in natural(at).iter().zip(corners) {
        for row in 0..2 {
            for column in 0..2 {
                j[(row, column)] += slope[row] * corner[column];
            }
        }
    }
    j
}

/// The operators at natural coordinates `at` with integration weight `weight`.
pub(super) fn point(corners: &[Point3<f64>], at: [f64; 2], weight: f64) -> Point<24> {
    let j = jacobian(corners, at);
    let determinant = j.determinant();
    let inverse = j.try_inverse().unwrap_or_else(Matrix2::zeros);
    let slopes = natural(at).map(|slope| inverse * Vector2::from(slope));
    let shapes = shape(at);
    let mut membrane = SMatrix::<f64, 3, 24>::zeros();
    let mut bending = SMatrix::<f64, 3, 24>::zeros();
    let mut drilling = RowSVector::<f64, 24>::zeros();
    let warp: Vector2<f64> = slopes.iter().zip(corners).map(|(slope, corner)| slope * corner[2]).sum();
    for (node, slope) in slopes.iter().enumerate() {
        let (c, x, y) = (6 * node, slope.x, slope.y);
        membrane[(0, c)] = x;
        membrane[(1, c + 1)] = y;
        membrane[(2, c)] = y;
        membrane[(2, c + 1)] = x;
        membrane[(0, c + 2)] = warp.x * x;
        membrane[(1, c + 2)] = warp.y * y;
        membrane[(2, c + 2)] = warp.x * y + warp.y * x;
        bending[(0, c + 4)] = x;
        bending[(1, c + 3)] = -y;
        bending[(2, c + 4)] = y;
        bending[(2, c + 3)] = -x;
        // About the surface's own normal (-z,x, -z,y, 1).
        drilling[c] = 0.5 * y;
        drilling[c + 1] = -0.5 * x;
        drilling[c + 2] = 0.5 * (warp.x * y - warp.y * x);
        drilling[c + 3] = -warp.x * shapes[node];
        drilling[c + 4] = -warp.y * shapes[node];
        drilling[c + 5] = shapes[node];
    }
    let (modes, mode_drilling) = incompatible(corners, at, determinant);
    let shear = inverse * covariant_shear(corners, at);
    let area_m2 = weight * determinant;
    Point {
        area_m2,
        thickness: 1.0,
        shape: shapes.to_vec(),
        membrane,
        bending,
        shear,
        drilling,
        modes,
        mode_drilling,
    }
}

/// Strains of the modes 1 - xi^2 and 1 - eta^2 of u and of v. With the Jacobian of the middle, scaled, they do no
/// work on constant stresses: the patch test.
fn incompatible(
    corners: &[Point3<f64>],
    at: [f64; 2],
    determinant: f64,
) -> (SMatrix<f64, 3, 4>, RowSVector<f64, 4>) {
    let middle = jacobian(corners, [0.0; 2]);
    let scale = middle.determinant() / determinant;
    let inverse = middle.try_inverse().unwrap_or_else(Matrix2::zeros) * scale;
    let mut strains = SMatrix::zeros();
    let mut drilling = RowSVector::zeros();
    for (mode, slope) in [Vector2::new(-2.0 * at[0], 0.0), Vector2::new(0.0, -2.0 * at[1])].iter().enumerate()
    {
        let slope = inverse * slope;
        strains[(0, 2 * mode)] = slope.x;
        strains[(2, 2 * mode)] = slope.y;
        strains[(1, 2 * mode + 1)] = slope.y;
        strains[(2, 2 * mode + 1)] = slope.x;
        drilling[2 * mode] = 0.5 * slope.y;
        drilling[2 * mode + 1] = -0.5 * slope.x;
    }
    (strains, drilling)
}

/// Covariant transverse shears, tied at the middles of the sides: along xi linear in eta between the sides
/// eta = -1 and 1, along eta linear in xi.
fn covariant_shear(corners: &[Point3<f64>], at: [f64; 2]) -> SMatrix<f64, 2, 24> {
    let mut rows = SMatrix::<f64, 2, 24>::zeros();
    for (direction, ties) in [[[0.0, -1.0], [0.0, 1.0]], [[-1.0, 0.0], [1.0, 0.0]]].iter().enumerate() {
        let across = 1 - direction;
        for tie in ties {
            let weight = 0.5 * (1.0 + tie[across] * at[across]);
            let j = jacobian(corners, *tie);
            let (slopes, shapes) = (natural(*tie), shape(*tie));
            for node in 0..4 {
                let c = 6 * node;
                rows[(direction, c + 2)] += weight * slopes[node][direction];
                rows[(direction, c + 3)] -= weight * j[(direction, 1)] * shapes[node];
                rows[(direction, c + 4)] += weight * j[(direction, 0)] * shapes[node];
            }
        }
    }
    rows
}
