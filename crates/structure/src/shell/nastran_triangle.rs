//! The transverse shear of Nastran's CTRIA3, whose curvature is constant.
//!
//! The shears along the three sides are those of a constant shear and of a part that goes round, alike along each: e = t . g + r. The
//! constant one has the flexibility of the section and of the bending that linear rotations lack (MacNeal, A simple quadrilateral shell element, Computers and
//! Structures 8, 1978): along each altitude h its square over 12 D11, the stiffness of bending along it. The part that goes round has 2 / (S11 + S22) of the section and
//! 2 A / (12 sqrt(D11 D22)), in axes with x along the first side. Found from prints of Simcenter Nastran 8.5 and MSC Nastran 2024, to all their digits.

use super::side_shears::{along, side_shears};
use crate::laminate::ShellSection;
use nalgebra::{Matrix2, Matrix3, Point3, RowVector3, SMatrix, Vector3};

/// Stiffness of transverse shear of a triangle of `area_m2` with `corners` over its plane; zero of a section that does not bend.
pub(super) fn shear_stiffness(
    corners: &[Point3<f64>],
    area_m2: f64,
    section: &ShellSection,
) -> SMatrix<f64, 18, 18> {
    let (mut constants, mut altitudes, mut along_altitudes) =
        (Matrix3::zeros(), Matrix3::zeros(), Vector3::zeros());
    for at in 0..3 {
        let side = along(corners, at);
        constants.set_row(at, &RowVector3::new(side.x, side.y, 1.0));
        let [c, s] = [-side.y, side.x];
        altitudes.set_row(at, &RowVector3::new(c * c, s * s, 2.0 * c * s));
        let curvature = Vector3::new(c * c, s * s, 2.0 * c * s);
        let height = 2.0 * area_m2 / (corners[(at + 1) % 3] - corners[at]).xy().norm();
        along_altitudes[at] = height * height / (12.0 * curvature.dot(&(section.bending * curvature)));
    }
    let Some(residual) = altitudes.try_inverse().map(|inverse| inverse * along_altitudes) else {
        return SMatrix::zeros();
    };
    let residual = Matrix2::new(residual.x, residual.z, residual.z, residual.y);
    let residual = if residual.cholesky().is_some() { residual } else { by_sides(corners, section) };
    let [d11, d22] = [0, 1].map(|axis| section.bending[(axis, axis)]);
    let around = 2.0 / section.shear.trace() + area_m2 / (6.0 * (d11 * d22).sqrt());
    let (Some(inverse), Some(own)) = (constants.try_inverse(), section.shear.try_inverse()) else {
        return SMatrix::zeros();
    };
    let shears = inverse * side_shears::<3, 18>(corners);
    let Some(constant) = (own + residual).try_inverse().filter(|_| around.is_finite()) else {
        return SMatrix::zeros();
    };
    let mut stiffness = Matrix3::zeros();
    stiffness.fixed_view_mut::<2, 2>(0, 0).copy_from(&constant);
    stiffness[(2, 2)] = 1.0 / around;
    shears.transpose() * (stiffness * area_m2) * shears
}

/// A residual flexibility that no shape and no laminate makes negative, for those with which that along the altitudes is: by the sides, as wide as
/// it of an isotropic section.
fn by_sides(corners: &[Point3<f64>], section: &ShellSection) -> Matrix2<f64> {
    let of_side = |at: usize| {
        let side = (corners[(at + 1) % 3] - corners[at]).xy();
        let [c, s] = [along(corners, at).x, along(corners, at).y];
        let curvature = Vector3::new(c * c, s * s, 2.0 * c * s);
        side * side.transpose() / (24.0 * curvature.dot(&(section.bending * curvature)))
    };
    (0..3).map(of_side).sum()
}
