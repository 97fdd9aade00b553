//! Transverse shears of a curved shell along its local coordinates.

use super::{CurvedShell, D};
use nalgebra::{RowSVector, SMatrix, Vector3};

/// Where a triangle's shears are tied, and along which direction of the local coordinates: both Gauss points of each side along it, and the
/// middle.
fn ties() -> [([f64; 2], [f64; 2]); 8] {
    let (near, far) = (0.5 * (1.0 - 1.0 / 3.0_f64.sqrt()), 0.5 * (1.0 + 1.0 / 3.0_f64.sqrt()));
    let middle = [1.0 / 3.0; 2];
    [
        ([near, 0.0], [1.0, 0.0]),
        ([far, 0.0], [1.0, 0.0]),
        ([far, near], [-1.0, 1.0]),
        ([near, far], [-1.0, 1.0]),
        ([0.0, far], [0.0, -1.0]),
        ([0.0, near], [0.0, -1.0]),
        (middle, [1.0, 0.0]),
        (middle, [0.0, 1.0]),
    ]
}

/// The fields that a triangle's shears are made of: linear ones, and two of second degree that are linear along every side.
fn fields([r, s]: [f64; 2]) -> SMatrix<f64, 2, 8> {
    SMatrix::from_row_slice(
        &[[1.0, r, s, 0.0, 0.0, 0.0, s * r, s * s], [0.0, 0.0, 0.0, 1.0, r, s, -r * r, -r * s]].concat(),
    )
}

impl CurvedShell {
    /// Transverse shears at a point: as they are in a quadrilateral, whose two by two points are free of those that bending has for want of
    /// higher functions; tied in a triangle.
    pub(super) fn shears(&self, at: [f64; 2]) -> SMatrix<f64, 2, D> {
        if !self.is_triangle() {
            return self.own_shears(at);
        }
        let (mut amounts, mut tied) = (SMatrix::<f64, 8, 8>::zeros(), SMatrix::<f64, 8, D>::zeros());
        for (row, (place, along)) in ties().into_iter().enumerate() {
            let along = RowSVector::<f64, 2>::from(along);
            amounts.row_mut(row).copy_from(&(along * fields(place)));
            tied.row_mut(row).copy_from(&(along * self.own_shears(place)));
        }
        fields(at) * (amounts.try_inverse().unwrap_or_else(SMatrix::zeros) * tied)
    }

    /// Transverse shears as the surface and its directors have them.
    fn own_shears(&self, at: [f64; 2]) -> SMatrix<f64, 2, D> {
        let functions = self.functions(at);
        let tangents = self.tangents(&functions);
        let director: Vector3<f64> = self.normals.iter().zip(&functions.values).map(|(d, n)| d * *n).sum();
        let mut rows = SMatrix::<f64, 2, D>::zeros();
        for (node, (slope, value)) in functions.slopes.iter().zip(&functions.values).enumerate() {
            for axis in 0..2 {
                let six =
                    self.six(node, director.transpose() * slope[axis], tangents[axis].transpose() * *value);
                rows.fixed_view_mut::<1, 6>(axis, 6 * node).copy_from(&six);
            }
        }
        rows
    }
}
