//! Where a flat shell lies: its plane, its axes and its corners over them.

use nalgebra::{Matrix3, Point3, Vector3};

/// Of three or four corners, an element's sine of the smallest angle below which it is degenerate.
const DEGENERATE: f64 = 1e-4;

/// Where an element lies.
pub(super) struct Frame {
    pub(super) axes: Matrix3<f64>,
    /// x, y and height above the plane.
    pub(super) corners: Vec<Point3<f64>>,
}

impl Frame {
    /// Of three or four corners; nothing of corners that span no area.
    pub(super) fn of(points: &[Point3<f64>]) -> Option<Self> {
        let count = points.len() as f64;
        let middle = points.iter().map(|point| point.coords).sum::<Vector3<f64>>() / count;
        let (one, other) = match points {
            [a, b, c] => (b - a, c - a),
            [a, b, c, d] => (c - a, d - b),
            _ => return None,
        };
        let normal = one.cross(&other).try_normalize(DEGENERATE * one.norm() * other.norm())?;
        let side = points[1] - points[0];
        let x = (side - normal * normal.dot(&side)).try_normalize(1e-12 * one.norm())?;
        let axes = Matrix3::from_rows(&[x.transpose(), normal.cross(&x).transpose(), normal.transpose()]);
        let corners = points.iter().map(|point| (axes * (point.coords - middle)).into()).collect();
        axes.iter().all(|value| value.is_finite()).then_some(Self { axes, corners })
    }

    /// Whether every corner turns left by a visible angle.
    pub(super) fn is_convex(&self) -> bool {
        let n = self.corners.len();
        (0..n).all(|at| {
            let [a, b, c] = [0, 1, 2].map(|step| self.corners[(at + step) % n]);
            let (one, other) = ([b[0] - a[0], b[1] - a[1]], [c[0] - b[0], c[1] - b[1]]);
            let cross = one[0] * other[1] - one[1] * other[0];
            cross > DEGENERATE * one[0].hypot(one[1]) * other[0].hypot(other[1])
        })
    }
}
